#pragma once

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <cmath>

/// Errors of velocity Verlet on the pendulum, to second order in the step, in closed form.
///
/// The steps lie on the exact motion of a nearby Hamiltonian (Hairer, Lubich & Wanner, Geometric Numerical Integration,
/// 2006, IX.8), in units w0 = 1, H = p^2/2 + V, V = 1 - cos x:
///   H~ = H + h^2 D + O(h^4),   D = p^2 V''/12 - V'^2/24 = p^2 cos x/12 - sin^2 x/24.
/// The start at rest at A fixes E~ = H(A, 0) + h^2 D(A, 0). The action at fixed energy changes by -h^2 oint D dt, and
/// the period is dJ/dE, so with I(A) = oint D dt over the exact motion, dE = sin A dA and p^2 = 2 (cos x - cos A):
///   T~ = T + h^2 T_1,   T_1 = [T'(A) D(A, 0) - I'(A)]/sin A.
/// With cos x = 1 - 2 q sn^2, q = sin^2(A/2), a = cos A = 1 - 2 q, K and E of parameter q:
///   oint cos x dt = 4 (2 E - K),   oint cos^2 x dt = (4/3) [K (4 q - 1) + E (4 - 8 q)],   oint dt = T = 4 K,
///   D = (5 cos^2 x - 4 a cos x - 1)/24,
///   T_1 = (1/2) [-(sin^2 A/24) dT/dq - dI/dq];   A -> 0: T_1 = -pi/12 = -T/24.
/// From A to the bottom the energy of the steps changes by h^2 (D(A, 0) - D(bottom)) = -h^2 [sin^2 A/24 +
/// (1 - cos A)/6].
namespace talus::verification::problems {

/// Relative change of the period over (w0 h)^2, T_1/T, for velocity Verlet released at rest at `amplitude` [rad].
inline double verlet_period_constant(double amplitude) {
  const double s = std::sin(0.5 * amplitude);
  const double c = std::cos(0.5 * amplitude);
  const double q = s * s;
  const double K = boost::math::ellint_1(s);
  const double E = boost::math::ellint_2(s);
  const double dK = (E - c * c * K) / (2.0 * q * c * c);
  const double dE = (E - K) / (2.0 * q);
  const double d_square = (4.0 / 3.0) * (dK * (4.0 * q - 1.0) + 4.0 * K + dE * (4.0 - 8.0 * q) - 8.0 * E);
  const double d_product = 4.0 * (-2.0 * (2.0 * E - K) + (1.0 - 2.0 * q) * (2.0 * dE - dK));  // of a oint cos x dt
  const double d_action = (5.0 * d_square - 4.0 * d_product - 4.0 * dK) / 24.0;
  const double d_period = 4.0 * dK;
  const double sine = std::sin(amplitude);
  return 0.5 * (-sine * sine / 24.0 * d_period - d_action) / (4.0 * K);
}

/// Energy at the bottom minus energy at the start, over m g a (w0 h)^2 [-]: the largest energy error of velocity Verlet
/// over any run.
inline double verlet_energy_swing(double amplitude) {
  const double sine = std::sin(amplitude);
  return -(sine * sine / 24.0 + (1.0 - std::cos(amplitude)) / 6.0);
}

}  // namespace talus::verification::problems
