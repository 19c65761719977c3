#pragma once

/// The undamped leapfrog (central difference, velocity Verlet) against a spring that only pushes, in closed form:
/// without a force the positions lie on a line, with it on a sine,
///
///   x(n+1) - 2 x(n) + x(n-1) = -eta^2 x(n) where x(n) > 0, else 0,   eta = w h < 2
namespace talus::verification::reference {

/// One bounce.
struct LeapfrogBounce {
  double ratio{};  ///< exit over entry speed, e
  double phase{};  ///< phi: of the step that leaves, the share spent outside of the spring
  long steps{};    ///< with a force
};

/// theta in (0, 1]: of the step that enters, the share spent inside. The bounce conserves u^2 + w^2 x(n) x(n+1), u the
/// speed of a step; at entry that is v0^2 (1 - eta^2 theta (1 - theta)), and the same with phi at exit:
///
///   e^2 = (1 - eta^2 theta (1 - theta)) / (1 - eta^2 phi (1 - phi)),   e <= 1/sqrt(1 - eta^2/4)
///
/// Errors: std::invalid_argument outside of 0 < eta < 2, 0 < theta <= 1.
[[nodiscard]] LeapfrogBounce leapfrog_bounce(double eta, double theta);

/// Means over `phases` even phases of entry.
struct LeapfrogGain {
  double least{};           ///< e
  double most{};            ///< e
  double mean{};            ///< of e
  double mean_ln{};         ///< of ln e
  double mean_square{};     ///< of e^2 - 1
  double variance{};        ///< mean of (e^2 - 1)^2
  double inverse_square{};  ///< of e^-2, which is one: the step keeps areas of (x, v), d(v^2) d(theta) = d(v'^2) d(phi)
};
[[nodiscard]] LeapfrogGain leapfrog_gain(double eta, int phases);

/// mean ln e of small eta: the mean of e^-2 is one, so that mean ln e is the variance of ln e to second order, and with
/// phi = theta + delta, delta the odd part of the contact's time in steps pi/(2 asin(eta/2)), that is
/// eta^4 delta^2 (1 - delta)^2 / 12.
[[nodiscard]] double small_step_heating(double eta);

}  // namespace talus::verification::reference
