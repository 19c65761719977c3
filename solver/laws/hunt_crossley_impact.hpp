#pragma once

namespace talus {

/// Impact of a mass m at the speed v by the force F = K d^n (1 + a/v dd/dt). With u = (dd/dt)/v, du/dd = F/(-m v^2 u)
/// separates,
///
///   K d^(n+1)/(n+1) = m v^2 [a (1 - u) - ln((1 + a)/(1 + a u))]/a^2,
///
/// so that the restitution e depends on the damping number a alone, for every exponent n:
///
///   ln((1 + a)/(1 - a e)) = a (1 + e)
///
/// (n = 3/2: Hunt & Crossley 1975 to first order in 1 - e.)
struct HuntCrossleyImpact {
  double restitution{};
  double contact_time{};     ///< in units of L/v
  double largest_overlap{};  ///< in units of L = (m v^2/K)^(1/(n+1))
};
/// The impact with damping number a >= 0 and exponent n >= 1.
[[nodiscard]] HuntCrossleyImpact hunt_crossley_impact(double damping_number, double exponent);

/// The restitution of that impact.
[[nodiscard]] double hunt_crossley_restitution(double damping_number);

/// The damping number that gives restitution e. Errors: InputError for e outside (0, 1].
[[nodiscard]] double hunt_crossley_damping_number(double e);

}  // namespace talus
