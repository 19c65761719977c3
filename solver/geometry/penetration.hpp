#pragma once

#include "solver/geometry/pose.hpp"
#include "solver/geometry/shape.hpp"

namespace talus {

/// Overlap of two outlines [L], independent of boundary nodes: the smallest displacement that separates them (the
/// minimum over all directions of their common extent along that direction); not positive where they are apart. Exact
/// for two rectangles, two circles, and with a half-plane; other pairs are searched over directions, and for a
/// superquadric the result is too large by at most a thousandth of its size.
/// For terrain it is the largest overlap of a point of the terrain with the other outline, or of a point of that
/// outline below the terrain's surface. Minus infinity if a shape has no outline.
[[nodiscard]] double penetration(const Shape& a, const Pose& A, const Shape& b, const Pose& B);

}  // namespace talus
