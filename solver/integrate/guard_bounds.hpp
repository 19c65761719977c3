#pragma once

namespace talus {

/// Bounds on all guards of a state.
struct GuardBounds {
  bool finite{};          ///< some guards may be finite; false: none is, and guards are not written
  double longest_step{};  ///< longest step from this state in which no body can pass through another unnoticed, at most
                          ///< the horizon [T]
};

}  // namespace talus
