#pragma once

#include "verification/reference/impacts/end_rule.hpp"

/// A particle that falls on a linear spring and dashpot. While these act, its overlap is a damped oscillation about
/// that at rest, m g/k. A clamped force ends while the particle is still below the surface, up to which it is then
/// thrown against gravity.
namespace talus::verification::reference {

struct WeightedImpact {
  double mass{};       ///< m [M] > 0
  double stiffness{};  ///< k [F/L] > 0
  double damping{};    ///< c [F T/L], in [0, 2 sqrt(k m))
  double gravity{};    ///< g [L/T^2] >= 0
  double speed{};      ///< downwards at touch [L/T] > 0
};

struct WeightedRebound {
  double force_time{};     ///< from the touch to the end of the force [T]
  double release_speed{};  ///< upwards at the end of the force [L/T]
  double restitution{};    ///< upward speed at the surface over the speed at touch; 0 if it does not get there
};

/// The times are found by bisection to round-off. Throws std::invalid_argument for parameters out of range, or
/// if the weight keeps the force from ending.
[[nodiscard]] WeightedRebound weighted_rebound(const WeightedImpact& impact, EndRule end);

}  // namespace talus::verification::reference
