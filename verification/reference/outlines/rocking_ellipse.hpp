#pragma once

/// A rigid ellipse that rocks back and forth on a plane without slip.
///
/// With the half axes a (horizontal) and b (vertical at rest) and the angle q from rest, the centre is at the support
/// height h(q) = sqrt(a^2 sin^2 q + b^2 cos^2 q) above the plane and at the distance h'(q) beside the contact point,
/// about which the body turns. Per unit mass, with the radius of gyration K^2 = (a^2 + b^2)/4 of a uniform disc,
///   (K^2 + h^2 + h'^2) q'^2/2 + g (h - b) = const,   w^2 = g (a^2/b - b)/(b^2 + K^2) for small oscillations.
namespace talus::verification::reference {

struct RockingEllipse {
  double a{}, b{};   ///< half axes [L], a > b
  double gravity{};  ///< g [L/T^2]
};

/// w of small oscillations [rad/T].
[[nodiscard]] double small_rocking_frequency(const RockingEllipse& ellipse);

/// Height of the centre, and its horizontal displacement from rest, -integral of h dq (rolling) [L].
[[nodiscard]] double centre_height(const RockingEllipse& ellipse, double angle);
[[nodiscard]] double centre_displacement(const RockingEllipse& ellipse, double angle);

/// Period of oscillations of any amplitude [rad] below a quarter turn: four times the integral of dq/q' from rest to
/// the amplitude, q = amplitude sin u, by the midpoint rule in u, which converges exponentially [T].
[[nodiscard]] double rocking_period(const RockingEllipse& ellipse, double amplitude);

/// Relative change of the frequency of small oscillations due to an elastic contact, to first order in the compliances:
/// the arm of friction is shortened by half the overlap m g/k_n, and its spring yields to m b w^2 q:
///   dw/w = [b g/k_n - b^2 w^2/k_s] m/(2 (b^2 + K^2)),   m of the body, k per contact.
[[nodiscard]] double frequency_shift(const RockingEllipse& ellipse, double mass, double normal_stiffness,
                                     double shear_stiffness);

}  // namespace talus::verification::reference
