#pragma once

#include "solver/scenes/scene.hpp"
#include "verification/check/findings.hpp"
#include "verification/reference/end_rule.hpp"

/// One impact of a scene, watched step by step while the solver runs it.
namespace talus::verification::problems {

/// What the first contact of a scene did in its first impact; all NaN when the run diverged or the contact did not end.
struct FollowedImpact {
  double approach_speed{};      ///< rate of the overlap at the last step before touch [L/T]
  double separation_speed{};    ///< minus that rate at the first step after the end [L/T]
  double end_time{};            ///< where overlap (attractive) or force (clamped) vanishes, linear between steps [T]
  double largest_depth{};       ///< largest of the steps [L]
  double least_deceleration{};  ///< least of -change of rate/step: < 0 where the surfaces were pulled together [L/T^2]
  State at_end;                 ///< the first state after the end

  [[nodiscard]] double restitution() const { return separation_speed / approach_speed; }
};

/// Runs `scene` by its own integrator and plan until its contact 0 has ended, and counts the evaluations in `findings`.
[[nodiscard]] FollowedImpact follow_impact(const Scene& scene, Findings& findings);

/// Reference and solver name the end rules alike and share no type.
[[nodiscard]] reference::EndRule same(EndRule rule);

/// Law with the damping ratio xi: c = 2 xi sqrt(k m).
[[nodiscard]] LinearSpringDashpot dashpot_of(double damping_ratio, double stiffness, double effective_mass,
                                             EndRule rule);

}  // namespace talus::verification::problems
