#pragma once

/// A rigid ellipse that rocks to and fro on a plane without slipping.
///
/// With the half axes a (lying) and b (standing at rest) and the angle q from rest, the centre stands at the support
/// h(q) = sqrt(a^2 sin^2 q + b^2 cos^2 q) above the plane and h'(q) beside the point of contact, about which the body
/// turns. Per unit of mass, with the radius of gyration K^2 = (a^2 + b^2)/4 of a uniform disc,
///   (K^2 + h^2 + h'^2) q'^2/2 + g (h - b) = const,   w^2 = g (a^2/b - b)/(b^2 + K^2) for small swings.
namespace talus::verification::reference {

struct RockingEllipse {
  double a{}, b{};   ///< half axes [L], a > b
  double gravity{};  ///< g [L/T^2]
};

/// w of small swings [rad/T].
[[nodiscard]] double small_rocking_frequency(const RockingEllipse& ellipse);

/// Height of the centre, and the way that it has gone sideways since rest, -integral of h dq (rolling) [L].
[[nodiscard]] double centre_height(const RockingEllipse& ellipse, double angle);
[[nodiscard]] double centre_way(const RockingEllipse& ellipse, double angle);

/// Period of swings of any amplitude [rad] below a quarter turn: four times the integral of dq/q' from rest to the
/// amplitude, q = amplitude sin u, by the midpoint rule in u, which converges exponentially [T].
[[nodiscard]] double rocking_period(const RockingEllipse& ellipse, double amplitude);

/// What an elastic contact does to the frequency of small swings, relative, to first order in the compliances: the arm
/// of friction is shorter by half the overlap m g/k_n, and its spring gives way under m b w^2 q:
///   dw/w = [b g/k_n - b^2 w^2/k_s] m/(2 (b^2 + K^2)),   m of the body, k per contact.
[[nodiscard]] double frequency_shift(const RockingEllipse& ellipse, double mass, double normal_stiffness,
                                     double shear_stiffness);

}  // namespace talus::verification::reference
