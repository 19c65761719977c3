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

/// Path whose ends lie (dx, dy) apart in the plane of motion, and part at (dvx, dvy); planes `across` apart along the
/// fence, given across^2 [L^2]. Ends that coincide have no direction and give a zero pull (a model with such ends is
/// refused when built). Without a branch, so that a compiler can compute several at a time.
[[nodiscard]] inline Path path(double dx, double dy, double dvx, double dvy, double across_squared) {
  const double length = std::sqrt(dx * dx + dy * dy + across_squared);
  // The least of all numbers changes no length but zero, where dx and dy are zero, too.
  const double inverse = 1.0 / (length + std::numeric_limits<double>::min());
  const double x = inverse * dx, y = inverse * dy;
  return {length, dvx * x + dvy * y, {x, y}};
}

/// The same from the ends' places and velocities.
[[nodiscard]] inline Path path(Vec2 p_WA, Vec2 v_WA, Vec2 p_WB, Vec2 v_WB, double across_squared) {
  const Vec2 r = p_WB - p_WA, v = v_WB - v_WA;
  return path(r.x, r.y, v.x, v.y, across_squared);
}

}  // namespace talus
