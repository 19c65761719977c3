#pragma once

#include <string>

#include "solver/io/scene/scene_table.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus {

/// Reads a scene file that describes a fence: `title` (optional), `units` and a table [fence], whose keys are the
/// members of scenes::Fence: [fence.ground], [[fence.rock]], [fence.column], and [fence.options] with the choices that
/// differ from the default ones, or with `rules = "1993"` from those of 1993. `source` is set to the file's units.
/// Errors: InputError with file, line, field, what was found and what is allowed.
[[nodiscard]] scenes::Fence read_fence(SceneTable& file, SceneSource& source);

/// The scene of a fence that was read from a table [fence]. Errors: InputError with the line of the field because of
/// which it cannot be built.
[[nodiscard]] scenes::FenceScene fence_scene(SceneTable& table, const scenes::Fence& fence);

}  // namespace talus
