#pragma once

#include <span>

#include "solver/dynamics/workspace.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/laws/settling.hpp"
#include "solver/model/layout.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Memory of one law instance in a state.
template <class L>
std::span<const double> memory(const State& state, Slot slot) {
  return std::span{state.z}.subspan(slot.memory, L::memory_size);
}

/// Brings the mode and memory of one law instance up to date, and books what that releases.
template <Law L>
void settle_mode(const L& law, Slot slot, Kinematics x, State& state, double copies) {
  const std::span memory{std::span{state.z}.subspan(slot.memory, L::memory_size)};
  settle(law, memory, x, state.mode[slot.mode],
         [&](double released) { state.work[static_cast<std::size_t>(L::release)] += copies * released; });
}

}  // namespace talus
