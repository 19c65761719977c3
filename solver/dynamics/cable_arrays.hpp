#pragma once

#include <algorithm>
#include <cstring>
#include <span>
#include <tuple>
#include <vector>

#include "solver/dynamics/lanes.hpp"
#include "solver/dynamics/law_modes.hpp"
#include "solver/laws/law.hpp"
#include "solver/model/layout.hpp"

/// Arrays of the cables, one for each law, and functions that visit their elements.
namespace talus {

/// All cables of one law.
template <class L>
struct CableArray {
  std::vector<std::size_t> cable;  ///< index of each in Workspace::paths
  std::vector<L> laws;
  std::vector<Slot> slots;
};

/// Position of the law of one cable: in the list of laws, and in its array.
struct CableIndex {
  std::size_t law{};
  std::size_t index{};
};

/// Calls visit(array, index of the law in the list) for the cables of each law.
template <class Laws, class Visit>
void for_each_array(const Laws& laws, Visit&& visit) {
  std::size_t law = 0;
  std::apply([&](const auto&... array) { (visit(array, law++), ...); }, laws);
}

/// Calls visit(law, slot, cable) for each cable, law by law.
template <class Laws, class Visit>
void for_each_cable(const Laws& laws, Visit&& visit) {
  for_each_array(laws, [&](const auto& array, std::size_t) {
    for (std::size_t i = 0; i < array.laws.size(); ++i)
      visit(array.laws[i], array.slots[i], array.cable[i]);
  });
}

/// Calls visit(array, span) for each span of a list of spans for each law.
template <class Laws, class Spans, class Visit>
void for_each_span(const Laws& laws, Spans& spans, Visit&& visit) {
  for_each_array(laws, [&](const auto& array, std::size_t law) {
    for (auto& span : spans[law])
      visit(array, span);
  });
}

/// Calls visit(law, slot, cable) for each cable of a span.
template <class Array, class Visit>
void for_each_of(const Array& array, const CableSpan& span, Visit&& visit) {
  const auto* const laws = &array.laws[span.index];
  const Slot* const slots = &array.slots[span.index];
  for (std::size_t i = 0, count = span.count, cable = span.cable; i < count; ++i)
    visit(laws[i], slots[i], cable + i);
}

/// Computes the linear branches of a span of cables.
template <class L>
[[gnu::noinline]] void make_lines(const CableArray<L>& array, const CableSpan& span, const State& state,
                                  CableLinearization& lines) {
  const Slot first = array.slots[span.index];
  std::copy_n(&state.mode[first.mode], span.count, &lines.mode[span.cable]);
  std::copy_n(state.z.data() + first.memory, L::memory_size * span.count, &lines.memory[span.cable]);
  for_each_of(array, span, [&](const L& law, Slot slot, std::size_t c) {
    lines.set(c, law.linear_branch(memory(law, state, slot), state.mode[slot.mode]));
  });
}

/// Computes the linear branches of a span if its modes or memories have changed since the last time: checked at each
/// evaluation, and rarely true.
template <class L>
[[gnu::always_inline]] inline void keep_lines(const CableArray<L>& array, const CableSpan& span, const State& state,
                                              CableLinearization& lines) {
  const Slot first = array.slots[span.index];
  bool same = std::memcmp(&state.mode[first.mode], &lines.mode[span.cable], span.count * sizeof(Mode)) == 0;
  // The array z of a state without memory is empty.
  if constexpr (L::memory_size > 0) {
    const double* const kept = state.z.data() + first.memory;
    const std::size_t numbers = L::memory_size * span.count;
    same = same && std::memcmp(kept, &lines.memory[span.cable], numbers * sizeof(double)) == 0;
  }
  if (!same) make_lines(array, span, state, lines);
}

/// Calls visit(law, slot) for one cable.
template <class Laws, class Visit>
void visit_cable(const Laws& laws, CableIndex at, Visit&& visit) {
  for_each_array(laws, [&](const auto& array, std::size_t law) {
    if (law == at.law) visit(array.laws[at.index], array.slots[at.index]);
  });
}

}  // namespace talus
