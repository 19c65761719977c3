#pragma once

#include <string>

#include "solver/geometry/shape.hpp"

namespace talus {

/// Largest exponent of a superquadric that may lie on its side by one resultant. A side of exponent n is so flat that
/// the contact point moves with the power 1/(n - 1) of the angle: up to 5 a body that rocks to rest takes some 10,000
/// evaluations of `stormer_cowell` at 1e-10; with 6 it takes millions.
inline constexpr double largest_rocking_exponent = 5.0;

/// Why a contact of these outlines by one resultant cannot be followed when they lie on each other: both have flat
/// sides, one of them that of a superquadric. Empty: it can.
[[nodiscard]] std::string objection_to_resultant(const Shape& a, const Shape& b);

}  // namespace talus
