#pragma once

#include <string_view>

#include "solver/io/scene/scene_file.hpp"

namespace talus {

/// Reads a scene from a TOML text: bodies with what acts between them and a plan, or a table [fence]. Quantities are
/// texts with units ("65 ft/s"), pure numbers are bare; `name` is the file named in errors.
/// Errors: InputError for everything in it that is wrong, of the form
/// `file.toml:17: body 'rock': mass: found "-3 kg"; it must be > 0`.
[[nodiscard]] SceneFile read_scene_file(std::string_view text, std::string_view name);

/// The scene alone.
[[nodiscard]] Scene read_scene(std::string_view text, std::string_view name);

/// Refuses a plan of more steps than can be run. Errors: InputError with the number of steps.
void check_step_count(const RunPlan& plan);

}  // namespace talus
