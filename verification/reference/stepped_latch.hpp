#pragma once

/// What an impact through a spring that latches keeps of its speed when it is taken in equal steps: K1 on the way in,
/// K2 on the way out, constant both (Walton & Braun, J. Rheology 30 (1986) 949). Derived here.
///
/// On a straight line x'' = -w^2 x a step is a linear map of (x, v):
///
///   euler      x + h v,              v - h w^2 x        determinant 1 + z^2,     z = w h
///   taylor     x + h v - z^2 x/2,    v - h w^2 x        determinant 1 + z^2/2
///   leapfrog   x + h v',             v' = v - h w^2 x   determinant 1
///
/// 1. So amplitudes grow by the root of the determinant D a step, and a step turns by the angle a, cos a = T/(2 sqrt
/// D),
///    T the trace. Energy gained along a quarter swing: a factor of 1 + z^2 a step in pi/(2z) steps, exp(pi z/2), with
///    euler; half of that exponent with taylor. Speed grows by the root. Both quarters:
///      e = sqrt(K1/K2) exp[c pi (w1 + w2) h],   c = 1/4 euler, 1/8 taylor, 0 leapfrog.
/// 2. Taylor's orbit is a tilted ellipse, w^2 x^2 - (w^2 h/2) x v + v^2 = const: as an angle it is pi/2 + t from x = 0
/// to
///    v = 0 and pi/2 - t back to x = 0, sin t = z/4, of which the growths do not cancel: -(w2^2 - w1^2) h^2/16 in ln e.
/// 3. Samples miss touch, turn and end by shares u, s, u' of a step; let g(u) = u - u^2. At the touch the first sample
///    is x = u h v with the speed of the approach, where the grown orbit has v (1 + g(u) z1^2/2): ln e loses g(u)
///    z1^2/2. At the end it gains g(u') z2^2/2 likewise. At the turn the branch changes from a sample M that is off the
///    top. With euler the samples go on growing to the first past the turn: -(z2^2 - z1^2) g(s)/2. With taylor the
///    larger of both sides is M: + (z2^2 - z1^2) min(s, 1 - s)^2/2. The leapfrog turns where its velocity does, between
///    samples: s counts from half a step before, and with its own invariant v^2 + w^2 x^2 (1 - z^2/4) it is -(z2^2 -
///    z1^2) g(s)/2 again.
/// Mean over phases of g: 1/6, of min^2: 1/12. So the mean of ln e is that of 1 and 2, but for taylor (z2^2 - z1^2)/8
/// more, which with 2 leaves (z2^2 - z1^2)/16. With determinant and angle in full, also in the shares, the next terms
/// are of fourth order.
namespace talus::verification::reference {

enum class StepMap { euler, taylor, leapfrog };

struct SteppedLatch {
  double ratio{};  ///< K1/K2 in (0, 1]
  double step{};   ///< w1 h > 0
  StepMap map{};
};

/// sqrt(K1/K2) exp[c pi (w1 + w2) h].
[[nodiscard]] double leading_restitution(const SteppedLatch& latch);

/// exp of the mean of ln e over phases, with growth and angle of a step in full. Not a number where a step swings no
/// more (w2 h >= 2).
[[nodiscard]] double mean_restitution(const SteppedLatch& latch);

/// Of one impact, `phase` of whose step had passed at the touch.
[[nodiscard]] double stepped_restitution(const SteppedLatch& latch, double phase);

}  // namespace talus::verification::reference
