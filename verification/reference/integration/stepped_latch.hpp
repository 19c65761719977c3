#pragma once

/// Restitution of an impact with a latching spring that is integrated with equal steps: constant stiffness K1 during
/// loading, K2 during unloading (Walton & Braun, J. Rheology 30 (1986) 949). Derived here.
///
/// On one branch x'' = -w^2 x, and a step is a linear map of (x, v):
///
///   euler      x + h v,              v - h w^2 x        determinant 1 + z^2,     z = w h
///   taylor     x + h v - z^2 x/2,    v - h w^2 x        determinant 1 + z^2/2
///   leapfrog   x + h v',             v' = v - h w^2 x   determinant 1
///
/// 1. Amplitudes therefore grow by the root of the determinant D per step, and the phase advances by the angle a per
///    step, cos a = T/(2 sqrt D), T the trace. Energy gained along a quarter period: with euler a factor of 1 + z^2 per
///    step over pi/(2z) steps, exp(pi z/2); with taylor half of that exponent. Speed grows by the root. Both quarters:
///      e = sqrt(K1/K2) exp[c pi (w1 + w2) h],   c = 1/4 euler, 1/8 taylor, 0 leapfrog.
/// 2. Taylor's orbit is a tilted ellipse, w^2 x^2 - (w^2 h/2) x v + v^2 = const: its angle is pi/2 + t from x = 0 to
///    v = 0 and pi/2 - t back to x = 0, sin t = z/4. The growths do not cancel: ln e changes by -(w2^2 - w1^2) h^2/16.
/// 3. Samples miss touch, turning point and end by fractions u, s, u' of a step; let g(u) = u - u^2. At touch the first
///    sample is x = u h v with the approach speed, where the growing orbit has v (1 + g(u) z1^2/2): ln e decreases by
///    g(u) z1^2/2. At the end it increases by g(u') z2^2/2 likewise. At the turning point the branch changes at a
///    sample M that is not the maximum. With euler the samples grow until the first after the turning point:
///    -(z2^2 - z1^2) g(s)/2. With taylor M is the larger of the samples on both sides:
///    +(z2^2 - z1^2) min(s, 1 - s)^2/2. The leapfrog turns where its velocity does, between samples: s is counted from
///    half a step before, and with the leapfrog invariant v^2 + w^2 x^2 (1 - z^2/4) it is -(z2^2 - z1^2) g(s)/2 again.
/// The mean over phases is 1/6 for g and 1/12 for min^2. So the mean of ln e is that of 1 and 2, except that taylor has
/// (z2^2 - z1^2)/8 more, which with 2 gives (z2^2 - z1^2)/16. With the exact determinant and angle, also in the
/// fractions, the next terms are of fourth order.
namespace talus::verification::reference {

enum class StepMap { euler, taylor, leapfrog };

struct SteppedLatch {
  double ratio{};  ///< K1/K2 in (0, 1]
  double step{};   ///< w1 h > 0
  StepMap map{};
};

/// Leading-order restitution, sqrt(K1/K2) exp[c pi (w1 + w2) h].
[[nodiscard]] double leading_restitution(const SteppedLatch& latch);

/// exp of the mean of ln e over phases, with the exact growth and angle of a step. NaN where a step no longer
/// oscillates (w2 h >= 2).
[[nodiscard]] double mean_restitution(const SteppedLatch& latch);

/// Restitution of one impact; the fraction `phase` of a step had elapsed at touch.
[[nodiscard]] double stepped_restitution(const SteppedLatch& latch, double phase);

}  // namespace talus::verification::reference
