#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "solver/dynamics/workspace.hpp"
#include "solver/laws/law.hpp"
#include "solver/laws/mode_update.hpp"
#include "solver/model/layout.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Memory of one law instance in a state.
template <class L>
std::span<const double> memory(const L& law, const State& state, Slot slot) {
  return std::span{state.z}.subspan(slot.memory, memory_count(law));
}
template <class L>
std::span<double> memory(const L& law, State& state, Slot slot) {
  return std::span{state.z}.subspan(slot.memory, memory_count(law));
}

/// Force of one law instance in its present mode.
template <Law L>
LawForce force_of(const L& law, Slot slot, Kinematics x, const State& state) {
  return law(x, memory(law, state, slot), state.mode[slot.mode]);
}

/// Slopes of a law's force in a mode [F/L and F T/L]: from the law where it is linear, else by central differences.
template <Law L>
Tangent local_slopes(const L& law, Kinematics x, std::span<const double> memory, Mode mode) {
  if constexpr (HasLinearPart<L>) {
    return law.linear_part(memory, mode);
  } else {
    const auto difference = [&](double by, double at_rate) {
      const Kinematics more{x.deformation + by, x.deformation_rate + at_rate},
          less{x.deformation - by, x.deformation_rate - at_rate};
      return 0.5 * (law(more, memory, mode).total() - law(less, memory, mode).total());
    };
    const double deformation = 1e-6 * std::abs(x.deformation),
                 rate = std::max(std::abs(x.deformation_rate), std::abs(x.deformation));
    if (deformation == 0.0) return law.tangent();
    return {difference(deformation, 0.0) / deformation, difference(0.0, rate) / rate};
  }
}

/// Updates the mode and memory of one law instance, and records the energy that this releases.
template <Law L>
void update_mode(const L& law, Slot slot, Kinematics x, State& state, double multiplicity) {
  update_mode(law, memory(law, state, slot), x, state.mode[slot.mode],
              [&](double released) { state.work[static_cast<std::size_t>(L::release)] += multiplicity * released; });
}

}  // namespace talus
