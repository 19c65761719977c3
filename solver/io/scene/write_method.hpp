#pragma once

#include <string>
#include <string_view>

#include "solver/advise/pilot.hpp"
#include "solver/io/scene/scene_file.hpp"

namespace talus {

/// Text of the scene file with another integration method and a comment at its end. For a scene of bodies the text is
/// preserved, including comments and order: only integrator, tolerance and step, and an interval shorter than the step,
/// are changed, in place, in [run]. A fence, also one read from a deck, is written from scratch: `steps` and
/// `step_factor` for the same end, histories and listing at the nearest times, `start = "plain"`, because the half kick
/// of 1993 is as long as the step. `name` is the file named in errors. Errors: InputError for a text whose [run] cannot
/// be changed in this way.
[[nodiscard]] std::string text_with_method(const SceneFile& file, std::string_view text, std::string_view name,
                                           const RunMethod& method, std::string_view comment);

/// The fence with the given method and the same end.
[[nodiscard]] scenes::Fence fence_with_method(const FenceInput& input, const RunMethod& method);

}  // namespace talus
