#pragma once

#include "verification/reference/impacts/end_rule.hpp"
#include "verification/study/runs/phase_sweep.hpp"

/// The three impacts of the time-step study, as input of sweeps, and the predictions of their errors.
namespace talus::verification::problems {

/// A disc that hits a wall; the exit speed has a closed form.
struct StruckDisc {
  double mass = 2.0;             ///< m [kg]
  double stiffness = 8e4;        ///< k [N/m]
  double speed = 1.5;            ///< v0 [m/s]
  double damping_ratio = 0.0;    ///< xi
  bool without_dashpot = false;  ///< injected fault: no dashpot in the scene, but in the reference
};
[[nodiscard]] PhasedImpact struck_disc(const StruckDisc& disc);

/// Case 1 of the 1993 report, its contact with restitution e (Eq. 21, attractive end); `mass_factor` is an injected
/// fault of the particle's mass in the scene.
[[nodiscard]] PhasedImpact struck_cables(double restitution, double mass_factor = 1.0);

/// Case 2 of the 1993 report, its contact with restitution e (damping from the pivoted mass, attractive end).
[[nodiscard]] PhasedImpact struck_column(double restitution);

/// rms over onset phases of the relative error of the exit speed of an undamped impact by the leapfrog methods, over
/// (1/N)^2. If the fraction theta of the first step is in contact, the quadratic form that the leapfrog conserves is
/// exactly v0^2 (1 - eta^2 theta (1 - theta)), eta = w h = pi/N; the exit, reversed in time, has the same form with a
/// different phase phi, so  v/v0 = sqrt((1 - eta^2 theta(1-theta))/(1 - eta^2 phi(1-phi))).  For one common offset
/// delta of all phases, phi = theta + delta mod 1, the mean square of the difference is delta^2 (1-delta)^2/3 (fourth
/// Bernoulli polynomial); for offsets spread evenly it is 2/180.
[[nodiscard]] double leapfrog_elastic_constant(double offset);
[[nodiscard]] double leapfrog_elastic_constant();  ///< offsets spread evenly

/// The same for rk4 with modes updated at every stage. A force ramp that begins a fraction u of a step before its end
/// has the impulse (2/3) max(u - 1/2, 0) + u/6 instead of u^2/2 (in w^2 v0 h^2): the excess f(u) has mean 0 and is
/// symmetric about 1/2, so v/v0 - 1 = eta^2 [f(u - delta) - f(u)].
[[nodiscard]] double rk4_elastic_constant(double offset);
[[nodiscard]] double rk4_elastic_constant();  ///< offsets spread evenly

/// rms of the relative error of e for rk4 in a damped impact, over w h. A force jump of 2 xi m w v0 at a fraction u of
/// a step before its end has the weight 5/6 (u > 1/2) or 1/6 instead of u: mean 0, mean square 1/36. The attractive end
/// is a second jump of the same relative size.
[[nodiscard]] double rk4_damped_constant(double damping_ratio, reference::EndRule end);

}  // namespace talus::verification::problems
