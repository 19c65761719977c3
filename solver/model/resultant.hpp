#pragma once

#include <string>

#include "solver/geometry/shape.hpp"

namespace talus {

/// Largest exponent of a superquadric that may lie on its side with one resultant force. On a side of exponent n the
/// contact point moves with the power 1/(n - 1) of the angle: up to 5, a body that rocks to rest takes about 10,000
/// evaluations of `stormer_cowell` at 1e-10; with 6 it takes millions.
inline constexpr double largest_rocking_exponent = 5.0;

/// Reason why a contact of these outlines with one resultant force cannot be simulated when they lie on each other:
/// both have flat sides, and at least one of them is a superquadric. Empty if it can.
[[nodiscard]] std::string resultant_error(const Shape& a, const Shape& b);

}  // namespace talus
