#pragma once

namespace talus {

/// What holds for all guards of a state.
struct GuardBounds {
  bool finite{};          ///< some of them may be; else they are not written
  double longest_step{};  ///< from there in which no body can pass another unseen; none beyond the time ahead [T]
};

}  // namespace talus
