#pragma once

#include <limits>

#include "solver/base/vec.hpp"

namespace talus {

/// The straight line of a cable between its ends A and B.
struct Path {
  double length{};       ///< [L]
  double length_rate{};  ///< [L/T], > 0 while lengthening
  Vec2 pull_A;           ///< in-plane part of the unit vector from A to B: the direction in which tension pulls end A
};

/// Path between two ends with relative position (dx, dy) [L] and relative velocity (dvx, dvy) [L/T] in the plane of
/// motion. Along the fence the ends are `across` apart, given as across^2 [L^2]. Coincident ends have no direction and
/// give a zero pull (a model with such ends is rejected when built). Branch-free, so that compilers can vectorise it.
[[nodiscard]] inline Path path(double dx, double dy, double dvx, double dvy, double across_squared) {
  const double length = std::sqrt(dx * dx + dy * dy + across_squared);
  // The smallest normal number changes only a zero length, and there dx and dy are zero, too.
  const double inverse = 1.0 / (length + std::numeric_limits<double>::min());
  const double x = inverse * dx, y = inverse * dy;
  return {length, dvx * x + dvy * y, {x, y}};
}

/// As above, from the positions and velocities of the ends.
[[nodiscard]] inline Path path(Vec2 p_WA, Vec2 v_WA, Vec2 p_WB, Vec2 v_WB, double across_squared) {
  const Vec2 r = p_WB - p_WA, v = v_WB - v_WA;
  return path(r.x, r.y, v.x, v.y, across_squared);
}

}  // namespace talus
