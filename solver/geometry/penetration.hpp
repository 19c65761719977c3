#pragma once

#include "solver/geometry/pose.hpp"
#include "solver/geometry/shape.hpp"

namespace talus {

/// Overlap of two outlines [L], independent of boundary nodes: the smallest displacement that separates them (the
/// minimum over all directions of their common extent along that direction); not positive where they are apart. Exact
/// for rectangles, circles and half-planes; for superquadrics it is too large by at most a thousandth of their size.
/// For terrain it is the depth of the terrain's deepest point in the other outline. Minus infinity if a shape has no
/// outline.
[[nodiscard]] double penetration(const Shape& a, const Pose& A, const Shape& b, const Pose& B);

}  // namespace talus
