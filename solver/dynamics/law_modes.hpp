#pragma once

#include <span>

#include "solver/dynamics/workspace.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/model/layout.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Memory of one law instance in a state.
template <class L>
std::span<const double> memory(const State& state, Slot slot) {
  return std::span{state.z}.subspan(slot.memory, L::memory_size);
}

/// Ends a mode whose guard is no longer positive: the law's reset takes over, until a mode lasts. A reset that keeps
/// the mode ends the search; no law passes through more than all of its modes at one instant.
template <Law L>
void end_mode(const L& law, std::span<double> memory, Kinematics x, Mode& mode, double copies, State& state) {
  for (std::size_t pass = 0; pass < L::modes.size(); ++pass) {
    const Reset next = law.reset(x, memory, mode);
    if (next.mode == mode) return;
    mode = next.mode;
    state.work[static_cast<std::size_t>(L::release)] += copies * next.released;
    if (law.guard(x, memory, mode) > 0.0) return;
  }
}

/// Brings the mode of one law instance, and the memory that follows the motion, up to date.
template <Law L>
void settle_mode(const L& law, Slot slot, Kinematics x, State& state, double copies) {
  Mode& mode = state.mode[slot.mode];
  const std::span memory{std::span{state.z}.subspan(slot.memory, L::memory_size)};
  if constexpr (requires { law.track(x, memory, mode); }) law.track(x, memory, mode);
  if (law.guard(x, memory, mode) > 0.0) return;
  end_mode(law, memory, x, mode, copies, state);
}

}  // namespace talus
