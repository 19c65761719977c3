#include "solver/io/output/run_record.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <variant>

#include "solver/dynamics/law_modes.hpp"

namespace talus {

std::vector<BodyState> body_states(const Model& model, const State& state) {
  const Layout layout{model};
  std::vector<BodyState> states;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const auto body = static_cast<BodyId>(i);
    const Pose at = pose(model, layout, state, body);
    states.push_back({model.bodies[i].name, at.p_WB, angle(model, layout, state, body), at.v_WB, at.w_WB});
  }
  return states;
}

std::vector<std::size_t> largest_impacts(const std::vector<ImpactRecord>& impacts, std::size_t count) {
  std::vector<std::size_t> order(impacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return impacts[i].impact.peak_force; });
  order.resize(std::min(order.size(), count));
  return order;
}

std::vector<PartState> cable_states(const Dynamics& dynamics, const State& state) {
  std::vector<PartState> states;
  for (std::size_t c = 0; c < dynamics.model().cables.size(); ++c) {
    const Slot slot = dynamics.layout().cable_slots[c];
    std::visit(
        [&]<class L>(const L& law) {
          states.push_back({dynamics.model().cables[c].name, L::modes[state.mode[slot.mode]],
                            natural_elongation(law, memory(law, state, slot))});
        },
        dynamics.model().cables[c].law);
  }
  return states;
}

std::vector<PartState> hanger_states(const Dynamics& dynamics, const State& state) {
  std::vector<PartState> states;
  for (std::size_t h = 0; h < dynamics.model().hangers.size(); ++h) {
    const bool broken = state.mode[dynamics.layout().first_hanger + h] != 0;
    states.push_back({dynamics.model().hangers[h].name, broken ? "broken" : "holds", 0.0});
  }
  return states;
}

void record_history(RunRecord& record, const Recorder& recorder) {
  const History& all = recorder.history();
  record.history.columns = all.columns;
  for (std::size_t i = 1; i < all.columns.size(); ++i)
    record.extremes.push_back({all.columns[i], recorder.extreme(i)});
  const auto is_finite = [](const std::vector<double>& row) {
    return std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); });
  };
  record.history.rows.assign(all.rows.begin(), std::find_if_not(all.rows.begin(), all.rows.end(), is_finite));
  record.rows_cut = all.rows.size() - record.history.rows.size();
  record.accounts = recorder.accounts();
  if (!recorder.ledger()) return;
  record.start_energies = recorder.ledger()->start();
  record.largest_energy_balance_error = recorder.ledger()->largest_energy_balance_error();
  record.energy_scale = recorder.ledger()->energy_scale();
}

}  // namespace talus
