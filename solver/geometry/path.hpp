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

/// Path between two points of planes of motion that lie `across` apart; given is across^2 [L^2].
/// Errors: none; ends that coincide have no direction and give a zero pull (a model with such ends is refused when
/// built).
[[nodiscard]] inline Path path(Vec2 p_WA, Vec2 v_WA, Vec2 p_WB, Vec2 v_WB, double across_squared) {
  const Vec2 r = p_WB - p_WA;
  const double length = std::sqrt(dot(r, r) + across_squared);
  // The least of all numbers changes no length but nought, where r is nought, too. A branch would keep a compiler from
  // working out several cables at a time.
  const Vec2 pull = (1.0 / (length + std::numeric_limits<double>::min())) * r;
  return {length, dot(v_WB - v_WA, pull), pull};
}

}  // namespace talus
