#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/base/units.hpp"

namespace talus {

/// Kinds of scenes that have a template: fence, scene, cell.
[[nodiscard]] std::vector<std::string> template_kinds();

/// A complete scene file of the given kind with a comment on every field, as a starting point for a new one; its
/// quantities are round numbers in `units`. Errors: InputError listing the known kinds.
[[nodiscard]] std::string scene_template(std::string_view kind, const UnitSystem& units);

}  // namespace talus
