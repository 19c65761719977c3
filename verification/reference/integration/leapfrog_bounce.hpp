#pragma once

/// The undamped leapfrog (central difference, velocity Verlet) against a spring that only pushes, in closed form: the
/// positions lie on a line without force and on a sine with force,
///
///   x(n+1) - 2 x(n) + x(n-1) = -eta^2 x(n) where x(n) > 0, else 0,   eta = w h < 2
namespace talus::verification::reference {

/// One bounce.
struct LeapfrogBounce {
  double ratio{};  ///< e, exit speed over entry speed
  double phase{};  ///< phi: fraction of the exit step spent outside the spring
  long steps{};    ///< number of steps with a force
};

/// Bounce for theta in (0, 1], the fraction of the entry step spent inside the spring. The bounce conserves u^2 + w^2
/// x(n) x(n+1), u the speed of a step; at entry this is v0^2 (1 - eta^2 theta (1 - theta)), and the same with phi at
/// exit:
///
///   e^2 = (1 - eta^2 theta (1 - theta)) / (1 - eta^2 phi (1 - phi)),   e <= 1/sqrt(1 - eta^2/4)
///
/// Throws std::invalid_argument outside 0 < eta < 2, 0 < theta <= 1.
[[nodiscard]] LeapfrogBounce leapfrog_bounce(double eta, double theta);

/// Means over `phases` equally spaced entry phases.
struct LeapfrogGain {
  double minimum{};         ///< minimum e
  double maximum{};         ///< maximum e
  double mean{};            ///< mean of e
  double mean_ln{};         ///< mean of ln e
  double mean_square{};     ///< mean of e^2 - 1
  double variance{};        ///< mean of (e^2 - 1)^2
  double inverse_square{};  ///< mean of e^-2, which is one: the step preserves areas of (x, v), d(v^2)
                            ///< d(theta) = d(v'^2) d(phi)
};
[[nodiscard]] LeapfrogGain leapfrog_gain(double eta, int phases);

/// mean ln e at small eta: the mean of e^-2 is one, so that mean ln e is the variance of ln e to second order. With
/// phi = theta + delta, delta the fractional part of the contact time in steps pi/(2 asin(eta/2)), this is eta^4
/// delta^2 (1 - delta)^2 / 12.
[[nodiscard]] double small_step_heating(double eta);

}  // namespace talus::verification::reference
