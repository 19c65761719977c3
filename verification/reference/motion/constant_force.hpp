#pragma once

/// One coordinate under a constant acceleration: exact solution and error of the semi-implicit Euler rule.
namespace talus::verification::reference {

struct ConstantForce {
  double position{};      ///< x0 at t = 0 [L]
  double speed{};         ///< v0 at t = 0 [L/T]
  double acceleration{};  ///< a [L/T^2]
};

/// x0 + v0 t + a t^2/2 [L] and v0 + a t [L/T], at 50 digits.
[[nodiscard]] double position_at(const ConstantForce& flight, double t);
[[nodiscard]] double speed_at(const ConstantForce& flight, double t);

/// Error of the position after `steps` steps of v += h a, x += h v: the speed in step i is v0 + i h a, so that
/// x = x0 + n h v0 + h^2 a n (n + 1)/2, which exceeds the exact position by a h t/2 [L], t = n h.
[[nodiscard]] double semi_implicit_euler_error(const ConstantForce& flight, double step, long steps);

}  // namespace talus::verification::reference
