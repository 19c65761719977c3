#pragma once

/// End of a spring-dashpot contact with force F = k d - c s (overlap d, separation rate s = -d', c s < 0 while
/// closing).
namespace talus::verification::reference {

enum class EndRule {
  attractive,  ///< F acts while d >= 0, so it pulls just before the end: behaviour of the 1993 report (Eq. 21 holds).
  clamped,     ///< Zero-tension cut-off (LAMMPS `limit_damping`): contact ends when F falls to zero, with d > 0.
};

}  // namespace talus::verification::reference
