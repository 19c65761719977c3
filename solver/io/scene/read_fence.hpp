#pragma once

#include <string>

#include "solver/io/scene/scene_table.hpp"
#include "solver/scenes/fence.hpp"

namespace talus {

/// Reads a scene file that describes a fence: `title` (may be left out), `units` and a table [fence], whose keys are
/// the members of scenes::Fence: [fence.ground], [[fence.rock]], [fence.column], and [fence.options] with the choices
/// that are not those of 1993. `source` takes the file's units. Errors: InputError with file, line, field, what was
/// found and what is allowed.
[[nodiscard]] scenes::Fence read_fence(SceneTable& file, SceneSource& source);

}  // namespace talus
