#pragma once

#include <string>
#include <vector>

#include "solver/scenes/scene.hpp"
#include "verification/check/case.hpp"
#include "verification/reference/damped_bounce.hpp"
#include "verification/study/followed_impact.hpp"

/// A disc of unit mass that falls on a plane through a linear spring and dashpot, with its weight.
namespace talus::verification::problems {

inline constexpr double gravity = 1.0, fall_height = 1.0;

/// The contact that it falls on.
struct Fall {
  double xi{};  ///< damping ratio
  EndRule rule{};
  double frequency{};  ///< w = sqrt(k/m) [rad/T]
};

[[nodiscard]] std::string name_of(const Fall& fall);  ///< "xi = 0.1, clamped"

/// The reference, from a gap at a speed towards the plane.
[[nodiscard]] reference::DampedBounce exact_fall(const Fall& fall, double gap, double speed);
/// The same for the solver. Faults: dashpot_halved, weight_halved, other_end_rule.
[[nodiscard]] Scene falling_disc(const Fall& fall, double gap, double speed, const Setup& setup);

/// From touch to the end without weight [T].
[[nodiscard]] double contact_time(const Fall& fall);

/// Apex gaps of the first bounces: of the parabola on which the disc is at the first step without a force. NaN where
/// the run diverged or the disc stayed.
[[nodiscard]] std::vector<double> apexes(const Scene& scene, double step, int bounces, Findings& findings);

}  // namespace talus::verification::problems
