#include "solver/run/failure_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/dynamics/law_modes.hpp"

namespace talus {
namespace {

/// Elongation at which a cable is just slack [L].
double elongation(const CableLaw& law, const State& state, Slot slot) {
  return std::visit([&](const auto& of) { return natural_elongation(of, memory(of, state, slot)); }, law);
}

}  // namespace

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
              if (L::yields(mode))
                watches_.push_back({slot.mode, mode, {0.0, part, "yields"}, false, &model.cables[c].law, slot});
            }
            if (is_broken<L>(mode)) watches_.push_back({slot.mode, mode, {0.0, part, "breaks"}, false, {}, {}});
          }
        },
        model.cables[c].law);
  }
  for (std::size_t h = 0; h < model.hangers.size(); ++h) {
    const std::string part = fmt::format("hanger '{}'", model.hangers[h].name);
    watches_.push_back({layout.first_hanger + h, Mode{1}, {0.0, part, "breaks"}, false, {}, {}});
  }
}

void FailureLog::operator()(const State& state, const StepInfo&) {
  for (Watch& watch : watches_) {
    if (watch.seen) continue;
    // Drawn out within a step, a cable may be taut again at its end.
    const bool drawn = watch.yielding && elongation(*watch.yielding, state, watch.memory) > 0.0;
    if (state.mode[watch.slot] != watch.mode && !drawn) continue;
    watch.seen = true;
    failures_.push_back(watch.failure);
    failures_.back().time = state.t;
  }
}

/// Times by the place of what is waited for, and the order in which it came.
void FailureLog::remember(Memory& memory) {
  std::vector<double> times, places;
  for (const Failure& failure : failures_) {
    const auto is = [&](const Watch& watch) {
      return watch.failure.part == failure.part && watch.failure.what == failure.what;
    };
    places.push_back(static_cast<double>(std::find_if(watches_.begin(), watches_.end(), is) - watches_.begin()));
    times.push_back(failure.time);
  }
  memory.list("times", times);
  places.resize(times.size());
  memory.numbers("places", places);
  if (!memory.puts_back()) return;
  failures_.clear();
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!(places[i] >= 0.0 && places[i] < static_cast<double>(watches_.size()))) {
      throw InputError{fmt::format("places: found {}; it must be from 0 to below {}", places[i], watches_.size())};
    }
    Watch& watch = watches_[static_cast<std::size_t>(places[i])];
    watch.seen = true;
    failures_.push_back(watch.failure);
    failures_.back().time = times[i];
  }
}

}  // namespace talus
