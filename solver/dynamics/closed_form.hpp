#pragma once

#include <optional>
#include <string>

#include "solver/model/model.hpp"

namespace talus {

/// Reason why the motion of a model between two events has no closed form here; none if it has one. It has one if the
/// bodies move freely under gravity and constant forces, and touch without friction, by laws that are linear in each
/// mode and along normals that never turn: a circle, or a body that does not turn, on a half-plane that does not turn,
/// and two circles that slide along one line.
[[nodiscard]] std::optional<std::string> obstacle_to_closed_form(const Model& model);

}  // namespace talus
