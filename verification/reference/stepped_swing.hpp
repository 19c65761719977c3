#pragma once

#include <cstdint>

/// The oscillator x'' = -x, let go at x = 1, by steps of a method: without rounding in closed form, and step by step in
/// numbers of 53, 64 and 113 bits.
namespace talus::verification::reference {

/// Leapfrog (velocity Verlet), or the classical Runge-Kutta method.
enum class SwingMethod { verlet, runge_kutta };

/// Numbers to step in: double, long double, and 113 bits of mantissa.
enum class Scalar { bits_53, bits_64, bits_113 };

/// Half a unit of the last place of 1: 2^-53, 2^-64, 2^-113.
[[nodiscard]] double unit_round_off(Scalar scalar);

/// x after `steps` steps of length `step`, at 50 digits. Verlet: x_{n+1} = (2 - h^2) x_n - x_{n-1}, so x_n = cos(n t),
/// sin(t/2) = h/2. Runge-Kutta: the real part of (1 - h^2/2 + h^4/24 + i (h - h^3/6))^n.
[[nodiscard]] double unrounded_place(SwingMethod method, double step, std::int64_t steps);

/// How far x is from that after `steps` steps in the numbers `scalar`.
[[nodiscard]] double rounding_error(SwingMethod method, Scalar scalar, double step, std::int64_t steps);

/// What the method itself is off by at t = n h, without rounding: x_n - cos t.
[[nodiscard]] double method_error(SwingMethod method, double step, std::int64_t steps);

}  // namespace talus::verification::reference
