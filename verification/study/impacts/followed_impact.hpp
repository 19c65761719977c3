#pragma once

#include "solver/scenes/scene.hpp"
#include "verification/check/findings.hpp"
#include "verification/reference/impacts/end_rule.hpp"

/// One impact of a scene, observed step by step during the run.
namespace talus::verification::problems {

/// First impact of the first contact of a scene; all NaN if the run diverged or the contact did not end.
struct FollowedImpact {
  double approach_speed{};        ///< rate of the overlap at the last step before touch [L/T]
  double separation_speed{};      ///< minus that rate at the first step after the end [L/T]
  double end_time{};              ///< time at which overlap (attractive) or force (clamped) vanishes, interpolated
                                  ///< linearly between steps [T]
  double largest_depth{};         ///< largest overlap at the steps [L]
  double minimum_deceleration{};  ///< minimum of -change of rate/step; < 0 if the force was attractive [L/T^2]
  State at_end;                   ///< the first state after the end

  [[nodiscard]] double restitution() const { return separation_speed / approach_speed; }
};

/// Runs `scene` with its integrator and plan until its contact 0 has ended, and adds the evaluations to `findings`.
[[nodiscard]] FollowedImpact follow_impact(const Scene& scene, Findings& findings);

/// The reference's end rule for one of the solver; the two have equal names but share no type.
[[nodiscard]] reference::EndRule same(EndRule rule);

/// Contact law with the damping ratio xi: c = 2 xi sqrt(k m).
[[nodiscard]] LinearSpringDashpot dashpot_of(double damping_ratio, double stiffness, double effective_mass,
                                             EndRule rule);

}  // namespace talus::verification::problems
