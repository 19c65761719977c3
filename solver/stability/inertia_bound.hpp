#pragma once

#include <string>

#include "solver/model/model.hpp"

namespace talus {

/// Largest distance of an outline from the centre of mass [L]; infinite for ground and for a body without an outline.
[[nodiscard]] double largest_distance(const Shape& shape);

/// Upper bound m R^2 of the moment of inertia of a body whose mass is within its outline, with the outline's largest
/// distance R from the centre of mass [M L^2]; infinite for ground and for a body without an outline.
[[nodiscard]] double inertia_bound(const Body& body);

/// Warning about the body whose moment of inertia exceeds its bound by the largest factor, with the number of others:
/// not an error, since a body may have parts beyond its outline. Empty if no body that turns exceeds it by more than
/// 0.1 %, for rounded input.
[[nodiscard]] std::string inertia_warning(const Model& model);

}  // namespace talus
