#pragma once

/// A rigid block that rocks from corner to corner without slipping or bouncing (Housner 1963).
///
/// With the half-width b, the half-height h, R = sqrt(b^2 + h^2), alpha = atan(b/h) and the tilt q > 0 about the corner
/// in contact, q'' = -p^2 sin(alpha - q), p^2 = m g R/(4 m R^2/3) = 3 g/(4 R), so that from rest at q0
///   q'^2 = 2 p^2 (cos(alpha - q0) - cos(alpha - q)).
/// At q = 0 the other corner meets the ground; the impulse acts there, so the angular momentum about it is conserved:
///   (I + m (h^2 - b^2)) w = (I + m R^2) w',   w'/w = 1 - (3/2) sin^2 alpha.
namespace talus::verification::reference {

struct RockingBlock {
  double half_width{}, half_height{};  ///< b, h [L]
  double gravity{};                    ///< [L/T^2]
};

/// Angle alpha [rad] and rate p [1/T].
[[nodiscard]] double block_angle(const RockingBlock& block);
[[nodiscard]] double block_rate(const RockingBlock& block);

/// Time from rest at the tilt q0 < alpha to q = 0 [T]: the integral of dq/q', q = q0 (1 - u^2), by Simpson's rule in u.
[[nodiscard]] double fall_time(const RockingBlock& block, double tilt);
/// Fall time of a slender block, sin(alpha - q)   alpha - q: acosh(1/(1 - q0/alpha))/p [T].
[[nodiscard]] double slender_fall_time(const RockingBlock& block, double tilt);

/// Ratio of the kinetic energies after and before an impact: (1 - (3/2) sin^2 alpha)^2.
[[nodiscard]] double impact_energy_ratio(const RockingBlock& block);

/// Potential energy of a tilted block relative to rest, per unit mass: g R (cos(alpha - q) - cos(alpha)) [L^2/T^2].
[[nodiscard]] double tilt_energy(const RockingBlock& block, double tilt);

}  // namespace talus::verification::reference
