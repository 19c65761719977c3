#pragma once

#include <string_view>

#include "solver/io/file/toml_document.hpp"
#include "solver/io/scene/scene_file.hpp"

namespace talus {

/// Reads a scene from a TOML text: bodies, the contacts, cables and hangers between them and a plan, or a table
/// [fence]. Quantities are quoted strings with units ("65 ft/s"), pure numbers are not quoted; `name` is the file named
/// in errors. Errors: InputError with all errors of the text, each of the form `file.toml:17: body 'rock': mass: found
/// "-3 kg"; it must be > 0`.
[[nodiscard]] SceneFile read_scene_file(std::string_view text, std::string_view name);

/// The same of a parsed TOML text.
[[nodiscard]] SceneFile read_scene_file(const TomlValue& document, std::string_view name);

/// As read_scene_file, but returns only the scene.
[[nodiscard]] Scene read_scene(std::string_view text, std::string_view name);

/// Rejects a plan with more steps than can be run, or with a step longer than the run. Errors: InputError with the
/// number of steps, or with both times.
void check_step_count(const RunPlan& plan);

}  // namespace talus
