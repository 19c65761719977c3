#pragma once

#include "solver/geometry/pose.hpp"
#include "solver/geometry/shape.hpp"

namespace talus {

/// How far two outlines reach into each other [L], by no node of either: the shortest way that takes one out of the
/// other, the least over all directions of what they have in common; not above zero where they are apart. Exact for
/// rectangles, circles and half-planes; of superquadrics to a thousandth of their size, from above. Of terrain it is
/// its deepest point in the other outline. Without an outline minus infinity.
[[nodiscard]] double penetration(const Shape& a, const Pose& A, const Shape& b, const Pose& B);

}  // namespace talus
