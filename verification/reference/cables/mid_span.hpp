#pragma once

/// A mass at mid-span of two straight cables without tension, displaced by w across them:
///
///     |----- L, k -----(m)----- L, k -----|        w
///
/// Each cable is then elongated by s = sqrt(L^2 + w^2) - L and pulls k s, of which w/sqrt(L^2 + w^2) acts against w:
///   P(w) = 2 k (1 - L/sqrt(L^2 + w^2)) w = k w^3/L^2 (1 - (3/4) (w/L)^2 + ...).
/// There is no linear term. In the limit of small w, x'' + beta x^3 = 0, beta = k/(m L^2); its energy gives
///   T = 4/(A sqrt(beta/2)) integral_0^1 du/sqrt(1 - u^4) = Gamma(1/4)^2/(sqrt(pi) A sqrt(beta)),
/// because the integral is B(1/4, 1/2)/4. The next term of the potential, k/(4 L^2) (w^4 - w^6/(2 L^2)), lengthens T:
///   dT/T = (A/2L)^2 [integral (1 - u^6) (1 - u^4)^(-3/2)]/[integral (1 - u^4)^(-1/2)] = (1/8 + 3/2 r^2) (A/L)^2,
/// r = Gamma(3/4)/Gamma(1/4), with the first integral as the difference of B(1/4, -1/2)/4 and B(7/4, -1/2)/4.
///
/// With steps h, leapfrog methods conserve H + h^2 D, D = v^2 U''/12 - U'^2/(24 m) (Hairer, Lubich & Wanner 2006,
/// IX.8), so that the period at the energy E of a start at rest at A changes by -h^2 d/dE (integral of D over a
/// period) + h^2 D(A) dT/dE. For U = m beta x^4/4 the integral of v^2 x^2 is beta/3 times that of x^6 (d(v x^3)/dt
/// integrates to zero), whose mean is (12/5) r^2 A^6, and
///   dT/T = (1 - 12 r^2)/24 beta A^2 h^2 < 0.
namespace talus::verification::reference {

struct MidSpan {
  double stiffness{};  ///< k of each cable [F/L] > 0
  double length{};     ///< L of each [L] > 0, straight and without tension
  double mass{};       ///< m [M] > 0
};

/// P(w) [F], with the sign of w.
[[nodiscard]] double mid_span_force(const MidSpan& span, double w);

/// Period of an oscillation of amplitude A > 0 [T], at 50 digits (takes milliseconds).
[[nodiscard]] double mid_span_period(const MidSpan& span, double amplitude);

/// Period of the cubic oscillator [T], and its relative increase due to finite A/L.
[[nodiscard]] double cubic_period(const MidSpan& span, double amplitude);
[[nodiscard]] double longer_by_amplitude(const MidSpan& span, double amplitude);

/// Relative change of the cubic oscillator's period due to steps of length h, < 0.
[[nodiscard]] double longer_by_steps(const MidSpan& span, double amplitude, double step);

}  // namespace talus::verification::reference
