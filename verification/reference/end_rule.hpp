#pragma once

/// When a spring-dashpot contact, of force F = k d - c s (depth d, separation rate s = -d', c s < 0 while closing),
/// ends.
namespace talus::verification::reference {

enum class EndRule {
  attractive,  ///< F acts while d >= 0, so it pulls just before the end: the 1993 report's behaviour (Eq. 21 holds).
  clamped,     ///< The contact ends where F falls to zero, some depth being left: it never pulls.
};

}  // namespace talus::verification::reference
