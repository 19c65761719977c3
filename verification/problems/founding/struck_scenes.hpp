#pragma once

#include "verification/reference/end_rule.hpp"
#include "verification/study/phase_sweep.hpp"

/// The three impacts of the time-step study, as sweeps take them, and what is predicted for their errors.
namespace talus::verification::problems {

/// A disc that meets a wall: closed form of the exit speed.
struct StruckDisc {
  double mass = 2.0;             ///< m [kg]
  double stiffness = 8e4;        ///< k [N/m]
  double speed = 1.5;            ///< v0 [m/s]
  double damping_ratio = 0.0;    ///< xi
  bool without_dashpot = false;  ///< planted fault: the scene has no dashpot, the reference has
};
[[nodiscard]] PhasedImpact struck_disc(const StruckDisc& disc);

/// Case 1 of the 1993 report, its contact with restitution e (Eq. 21, attractive end); `mass_factor` falsifies the
/// scene's particle.
[[nodiscard]] PhasedImpact struck_cables(double restitution, double mass_factor = 1.0);

/// Case 2 of the 1993 report, restitution e by the damping of the pivoted mass, attractive end.
[[nodiscard]] PhasedImpact struck_column(double restitution);

/// rms over onset phases of the relative error of the exit speed of an undamped impact by the leapfrog methods, over
/// (1/N)^2. With the step's fraction theta left of the first step in contact the conserved form of the leapfrog is
/// v0^2 (1 - eta^2 theta (1 - theta)), eta = w h = pi/N, exactly; the exit, reversed in time, has the same with its own
/// phase phi, so  v/v0 = sqrt((1 - eta^2 theta(1-theta))/(1 - eta^2 phi(1-phi))).  For one common offset delta of all
/// phases, phi = theta + delta mod 1, the mean square of the difference is delta^2 (1-delta)^2/3 (fourth Bernoulli
/// polynomial); for offsets spread evenly it is 2/180.
[[nodiscard]] double leapfrog_elastic_constant(double offset);
[[nodiscard]] double leapfrog_elastic_constant();  ///< offsets spread evenly

/// The same for rk4 with modes settled at every stage. A force ramp that begins u of a step before its end gets the
/// impulse (2/3) max(u - 1/2, 0) + u/6 instead of u^2/2 (in w^2 v0 h^2): the excess f(u) has mean 0 and is symmetric
/// about 1/2, so v/v0 - 1 = eta^2 [f(u - delta) - f(u)].
[[nodiscard]] double rk4_elastic_constant(double offset);
[[nodiscard]] double rk4_elastic_constant();  ///< offsets spread evenly

/// rms of the relative error of e for rk4 in a damped impact, over w h. A force jump of 2 xi m w v0 that falls u of a
/// step before its end gets the weight 5/6 (u > 1/2) or 1/6 instead of u: mean 0, mean square 1/36. The attractive end
/// is a second jump of the same relative size.
[[nodiscard]] double rk4_damped_constant(double damping_ratio, reference::EndRule end);

}  // namespace talus::verification::problems
