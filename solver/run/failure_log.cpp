#include "solver/run/failure_log.hpp"

#include <fmt/format.h>

#include <variant>

namespace talus {

FailureLog::FailureLog(const Dynamics& dynamics) {
  const Model& model = dynamics.model();
  const Layout& layout = dynamics.layout();
  for (std::size_t c = 0; c < model.cables.size(); ++c) {
    const std::string part = fmt::format("cable '{}'", model.cables[c].name);
    std::visit(
        [&]<class L>(const L&) {
          for (std::size_t mode = 0; mode < L::modes.size(); ++mode) {
            const std::string_view what = L::modes[mode] == "yielding" ? "yields" : "breaks";
            if (L::modes[mode] != "yielding" && L::modes[mode] != "broken") continue;
            watches_.push_back({layout.cable_slots[c].mode, static_cast<Mode>(mode), {0.0, part, what}, false});
          }
        },
        model.cables[c].law);
  }
  for (std::size_t h = 0; h < model.hangers.size(); ++h) {
    const std::string part = fmt::format("hanger '{}'", model.hangers[h].name);
    watches_.push_back({layout.first_hanger + h, Mode{1}, {0.0, part, "breaks"}, false});
  }
}

void FailureLog::operator()(const State& state, const StepInfo&) {
  for (Watch& watch : watches_) {
    if (watch.seen || state.mode[watch.slot] != watch.mode) continue;
    watch.seen = true;
    failures_.push_back(watch.failure);
    failures_.back().time = state.t;
  }
}

}  // namespace talus
