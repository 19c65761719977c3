#include "solver/run/failure_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/dynamics/law_modes.hpp"

namespace talus {

/// Checks the memory, not only the mode: a cable that yields within a step may be elastic again at its end.
bool FailureLog::drawn_out(const Watch& watch, const State& state) {
  if (!watch.yielding) return false;
  return std::visit([&](const auto& law) { return natural_elongation(law, memory(law, state, watch.slot)) > 0.0; },
                    *watch.yielding);
}

FailureLog::FailureLog(const Dynamics& dynamics) {
  const Model& model = dynamics.model();
  const Layout& layout = dynamics.layout();
  for (std::size_t c = 0; c < model.cables.size(); ++c) {
    const std::string part = fmt::format("cable '{}'", model.cables[c].name);
    std::visit(
        [&]<class L>(const L&) {
          const Slot slot = layout.cable_slots[c];
          for (Mode mode = 0; mode < L::modes.size(); ++mode) {
            if constexpr (Yields<L>) {
              if (L::yields(mode)) {
                watches_.push_back({.slot = slot, .mode = mode, .yielding = &model.cables[c].law});
                awaited_.push_back({0.0, part, "yields"});
              }
            }
            if (!is_broken<L>(mode)) continue;
            watches_.push_back({.slot = slot, .mode = mode});
            awaited_.push_back({0.0, part, "breaks"});
          }
        },
        model.cables[c].law);
  }
  for (std::size_t h = 0; h < model.hangers.size(); ++h) {
    const std::string part = fmt::format("hanger '{}'", model.hangers[h].name);
    watches_.push_back({.slot = {.mode = layout.first_hanger + h}, .mode = Mode{1}});
    awaited_.push_back({0.0, part, "breaks"});
  }
}

bool FailureLog::has_changed(const State& state) {
  const auto same = [](const auto& kept, const auto& now) {
    if (kept.size() != now.size() || now.empty()) return kept.size() == now.size();
    return std::memcmp(kept.data(), now.data(), now.size() * sizeof(now[0])) == 0;
  };
  const auto may_yield = [](const Watch& watch) { return watch.yielding && !watch.seen; };
  const bool same_modes = !state.mode.empty() && same(modes_, state.mode);
  if (same_modes && std::none_of(watches_.begin(), watches_.end(), may_yield)) return false;
  if (same_modes && !state.z.empty() && same(memory_, state.z)) return false;
  modes_ = state.mode, memory_ = state.z;
  return true;
}

void FailureLog::operator()(const State& state, const StepInfo&) {
  if (!has_changed(state)) return;
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    Watch& watch = watches_[i];
    if (watch.seen || (state.mode[watch.slot.mode] != watch.mode && !drawn_out(watch, state))) continue;
    watch.seen = true;
    failures_.push_back(awaited_[i]);
    failures_.back().time = state.t;
  }
}

/// Serializes, for each failure in order of occurrence, its time and its index among the awaited failures.
void FailureLog::serialize(Archive& archive) {
  std::vector<double> times, indices;
  for (const Failure& failure : failures_) {
    const auto is = [&](const Failure& awaited) {
      return awaited.part == failure.part && awaited.what == failure.what;
    };
    indices.push_back(static_cast<double>(std::find_if(awaited_.begin(), awaited_.end(), is) - awaited_.begin()));
    times.push_back(failure.time);
  }
  archive.list("times", times);
  indices.resize(times.size());
  archive.numbers("indices", indices);
  if (!archive.is_loading()) return;
  failures_.clear();
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!(indices[i] >= 0.0 && indices[i] < static_cast<double>(watches_.size()))) {
      throw InputError{fmt::format("indices: found {}; it must be from 0 to below {}", indices[i], watches_.size())};
    }
    const auto index = static_cast<std::size_t>(indices[i]);
    watches_[index].seen = true;
    failures_.push_back(awaited_[index]);
    failures_.back().time = times[i];
  }
}

}  // namespace talus
