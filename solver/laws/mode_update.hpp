#pragma once

#include <cstddef>
#include <span>

#include "solver/laws/law.hpp"

namespace talus {

/// Brings the mode of a law, and the memory that follows the motion, up to date: ends a mode whose guard is no longer
/// positive; the law's reset takes over, until a mode lasts. A reset that keeps the mode ends the search; no law passes
/// through more than all of its modes at one instant. Calls release(energy) for what each change lets go [F L].
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
