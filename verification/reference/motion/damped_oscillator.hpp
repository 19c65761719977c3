#pragma once

/// Exact motion of a mass between a linear spring and a dashpot, below critical damping.
///
/// y = displacement from rest [L], a = xi w0 [1/T], w = w0 sqrt(1 - xi^2) [1/T]:
///   y = exp(-a t) [y0 cos(w t) + (v0 + a y0)/w sin(w t)]
/// The energy dissipated by a dashpot c is c times the integral of v^2, which is integrated in closed form, not derived
/// from the energy.
namespace talus::verification::reference {

struct DampedOscillator {
  double frequency{};      ///< w0 = sqrt(k/m) [rad/T] > 0
  double damping_ratio{};  ///< xi = c/(2 m w0) in [0, 1)
  double displacement{};   ///< y0 [L]
  double velocity{};       ///< v0 [L/T]
};

struct OscillatorState {
  double displacement{};      ///< y [L]
  double velocity{};          ///< v [L/T]
  double squared_velocity{};  ///< integral of v^2 from 0 to t [L^2/T]
};

/// State at a time t >= 0 [T]. Throws std::invalid_argument for parameters out of range.
[[nodiscard]] OscillatorState state_at(const DampedOscillator& oscillator, double t);

}  // namespace talus::verification::reference
