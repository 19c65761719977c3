#pragma once

#include <span>
#include <vector>

/// A mass hung by a linear spring (a cable that never goes slack), as a pendulum in the plane; and its rigid limit.
///
///   elongation d = sqrt(x^2 + y^2) - L, tension T = k d;  m x'' = -T x/r,  m y'' = -T y/r - m g  (pin at 0, y up).
/// Released at rest at the angle A from the vertical, with the elongation that balances the load: d = m g cos(A)/k.
///
/// Leading-order effect of the stiffness on the period, eps = m g/(k L). With r = L + d the Lagrangian is
///   m r^2 th'^2/2 + m g r cos th + m d'^2/2 - k d^2/2.
/// A stiff spring is in balance with its load, d = T/k with T = m L th'^2 + m g cos th, so that the Lagrangian is
/// L_rigid + T^2/(2k) + O(eps^2).
/// A small change dL of the Lagrangian changes the action J(E) = oint p dq at fixed energy by oint dL dt, and the
/// period is dJ/dE. At the turning point E = -m g L cos A - (m g cos A)^2/(2k). Hence at fixed amplitude, in units
/// m = g = L = 1 (E_rigid = -cos A, dE = sin A dA, T = 3 cos th - 2 cos A on the rigid motion):
///   T(eps) = T_0 + eps T_1,   T_1 = [ (1/2) dI/dA - (1/2) cos^2 A dT_0/dA ]/sin A,
///   I = oint (3 cos th - 2 cos A)^2 dt.
/// With cos th = 1 - 2 q sn^2, q = sin^2(A/2), and the integrals of sn^2 and sn^4,
///   I = 4 [ K (16 q^2 - 28 q + 13) + E (24 q - 12) ],  T_0 = 4 K,  T_1 = (1/4) [ dI/dq - (1 - 2q)^2 4 dK/dq ].
/// A -> 0: T_1 = pi = T_0/2, which is the exact small oscillation 2 pi sqrt((L + m g/k)/g) to first order. (Derived
/// here.)
namespace talus::verification::reference {

/// Any consistent system of units.
struct ElasticPendulum {
  double mass{1.0};     ///< m [M] > 0.
  double length{1.0};   ///< L [L], unstretched, > 0.
  double gravity{1.0};  ///< g [L/T^2] > 0.
  double stiffness{};   ///< k [F/L] > 0.
  double amplitude{};   ///< A [rad], 0 < A < pi/2: the spring stays in tension.
};

[[nodiscard]] double softness(const ElasticPendulum& pendulum);  ///< eps = m g/(k L) [-].

struct ElasticPendulumState {
  double x{};   ///< [L].
  double y{};   ///< [L], the pin at 0.
  double vx{};  ///< [L/T].
  double vy{};  ///< [L/T].
};

/// States at ascending times >= 0 [T] from the release above, by `Trajectory` (Fehlberg 7(8), long double).
[[nodiscard]] std::vector<ElasticPendulumState> elastic_pendulum_states(const ElasticPendulum& pendulum,
                                                                        std::span<const double> times);

/// Time between the first and third passage through x = 0 [T], located. Costs a few hundred times sqrt(1/eps) steps.
[[nodiscard]] double elastic_pendulum_period(const ElasticPendulum& pendulum);

/// Period of the rigid pendulum of length L at the same amplitude [T]: 4 K(sin(A/2)) sqrt(L/g).
[[nodiscard]] double rigid_period(const ElasticPendulum& pendulum);

/// (d period/d eps at eps = 0)/(rigid period) = T_1/T_0: the relative period change is eps times this; 1/2 at A -> 0.
[[nodiscard]] double period_softening(double amplitude);

}  // namespace talus::verification::reference
