#pragma once

#include <array>
#include <functional>

/// A body with three coordinates and smooth motion, and the leading term of the error of leapfrog methods for it.
///
/// The motion is q'' = a(q, q', z, t), with history variables z' = s(q) q' that follow the motion. Leapfrog positions
/// lie on a smooth curve y with (y(t+h) - 2 y(t) + y(t-h))/h^2 = a. Expansion with y = q + h^p e gives an equation for
/// e:
///
///   no dashpot, p = 2:   e'' = Da[e] - q''''/12
///                        e_z' = D(s q')[e] + (Ds[q''] q')/8 + s q'''/24 - (s q')''/24    (midpoint rule on the chord)
///   dashpots,   p = 1:   e'' = Da[e] - g a_v q'',   the dashpot's velocity lags by g steps
///
/// and e(0), e'(0) follow from how the method starts. The method's velocities equal those of the curve to within q'''/6
/// (velocity Verlet) or q'''/24 (central difference), which is also added to e at the end.
namespace talus::verification::reference {

using Real = long double;
using Triple = std::array<Real, 3>;
using Memories = std::array<Real, 2>;

/// Positions and velocities (x, y, angle) and history variables; also used for their rates and errors.
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

/// Time derivative dx/dt.
[[nodiscard]] SmoothState rate(const SmoothSystem& system, const SmoothState& x, Real t);

/// State at `end`, from t = 0, by `steps` steps of the classical Runge-Kutta method.
[[nodiscard]] SmoothState moved(const SmoothSystem& system, const SmoothState& start, Real end, long steps);

enum class Leapfrog {
  velocity_verlet,
  central_difference,
  lagged_central_difference,
  euler_cromer,
  late_slip,  ///< velocity Verlet with the slip along the directions at the end of a step: s(q(t+h)) (q(t+h) - q(t))
};

/// Order of the method: 2, or 1 with dashpots, for Euler-Cromer and for late_slip, which adds (Ds[q'] q')/2 to e_z'.
[[nodiscard]] int order(Leapfrog method, const SmoothSystem& system);

/// Difference between the method's state and the motion at `end`, over step^order, in the limit of small steps;
/// computed by Runge-Kutta with `steps` steps.
[[nodiscard]] SmoothState leading_error(const SmoothSystem& system, const SmoothState& start, Real end, Leapfrog method,
                                        long steps);

}  // namespace talus::verification::reference
