#pragma once

#include <array>
#include <functional>

/// A body of three coordinates that moves smoothly, and the leading term of the error with which leapfrog methods
/// follow it.
///
/// The motion is q'' = a(q, q', z, t), with a memory z' = s(q) q' that follows the motion. Leapfrog places lie on a
/// smooth curve y with (y(t+h) - 2 y(t) + y(t-h))/h^2 = a. Expanded, with y = q + h^p e, that is an equation for e:
///
///   no dashpot, p = 2:   e'' = Da[e] - q''''/12
///                        e_z' = D(s q')[e] + (Ds[q''] q')/8 + s q'''/24 - (s q')''/24    (midpoint rule on the chord)
///   dashpots,   p = 1:   e'' = Da[e] - g a_v q'',   the velocity that a dashpot sees lags by g steps
///
/// and e(0), e'(0) follow from how the method starts; its velocities are those of the curve to within q'''/6 (velocity
/// Verlet) or q'''/24 (central difference), and so is what is added to e at the end.
namespace talus::verification::reference {

using Real = long double;
using Triple = std::array<Real, 3>;
using Memories = std::array<Real, 2>;

/// Places and velocities (x, y, angle) and memory; also rates and errors of such.
struct SmoothState {
  Triple q{};
  Triple v{};
  Memories z{};
};

[[nodiscard]] SmoothState operator+(const SmoothState& a, const SmoothState& b);
[[nodiscard]] SmoothState operator*(Real factor, const SmoothState& a);

struct SmoothSystem {
  std::function<Triple(const SmoothState& x, Real t)> acceleration;
  std::function<Memories(const Triple& q, const Triple& v)> slip;  ///< dz/dt, linear in v
  bool damped{};                                                   ///< the acceleration depends on v
};

/// dx/dt.
[[nodiscard]] SmoothState rate(const SmoothSystem& system, const SmoothState& x, Real t);

/// The motion at `end`, from t = 0, by `steps` steps of the classical Runge-Kutta method.
[[nodiscard]] SmoothState moved(const SmoothSystem& system, const SmoothState& start, Real end, long steps);

enum class Leapfrog {
  velocity_verlet,
  central_difference,
  lagged_central_difference,
  euler_cromer,
  late_slip,  ///< velocity Verlet whose slip is that along the directions of a step's end: s(q(t+h)) (q(t+h) - q(t))
};

/// Order with which the method follows the motion: 2, or 1 with dashpots, for Euler-Cromer and where the slip is late,
/// which adds (Ds[q'] q')/2 to e_z'.
[[nodiscard]] int order(Leapfrog method, const SmoothSystem& system);

/// What the method's state at `end` differs by from the motion, over step^order, as the step goes to zero; Runge-Kutta
/// with `steps` steps.
[[nodiscard]] SmoothState leading_error(const SmoothSystem& system, const SmoothState& start, Real end, Leapfrog method,
                                        long steps);

}  // namespace talus::verification::reference
