#pragma once

#include <cstddef>
#include <span>

#include "solver/laws/law.hpp"

namespace talus {

/// Updates the mode of a law and the memory that follows the motion: while the guard of the mode is not positive, the
/// law's reset selects the next mode. The loop ends when the guard is positive, when a reset keeps the mode, or after
/// as many changes as the law has modes. Calls release(energy) with the energy that each change releases [F L].
template <Law L, class Release>
void update_mode(const L& law, std::span<double> memory, Kinematics x, Mode& mode, Release&& release) {
  if constexpr (Tracks<L>) law.track(x, memory, mode);
  if (law.guard(x, memory, mode) > 0.0) return;
  for (std::size_t pass = 0; pass < L::modes.size(); ++pass) {
    const Reset next = law.reset(x, memory, mode);
    if (next.mode == mode) return;
    mode = next.mode;
    release(next.released);
    if (law.guard(x, memory, mode) > 0.0) return;
  }
}

}  // namespace talus
