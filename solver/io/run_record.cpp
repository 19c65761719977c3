#include "solver/io/run_record.hpp"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

/// Whether a column is drawn from the ledger, which a run may go without.
bool needs_ledger(const Column& column) {
  return column.name.rfind("lost.", 0) == 0 || column.name.rfind("closure.", 0) == 0;
}

}  // namespace

std::vector<BodyState> body_states(const Model& model, const State& state) {
  std::vector<BodyState> states;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const auto body = static_cast<BodyId>(i);
    const Pose at = pose(model, state, body);
    states.push_back({model.bodies[i].name, at.p_WB, angle(model, state, body), at.v_WB, at.w_WB});
  }
  return states;
}

void record_history(RunRecord& record, const Recorder& recorder) {
  const History& all = recorder.history();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < all.columns.size(); ++i) {
    if (!record.plan.ledger && needs_ledger(all.columns[i])) continue;
    kept.push_back(i);
    record.history.columns.push_back(all.columns[i]);
    if (i > 0) record.extremes.push_back({all.columns[i], recorder.extremes().at(i)});
  }
  for (const std::vector<double>& row : all.rows) {
    std::vector<double> values;
    for (const std::size_t i : kept)
      values.push_back(row[i]);
    if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) break;
    record.history.rows.push_back(std::move(values));
  }
  record.rows_cut = all.rows.size() - record.history.rows.size();
  record.accounts = recorder.accounts();
  record.largest_energy_closure = recorder.ledger().largest_energy_closure();
  record.energy_scale = recorder.ledger().energy_scale();
}

}  // namespace talus
