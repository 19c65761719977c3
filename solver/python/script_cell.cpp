#include "solver/python/script_cell.hpp"

#include <utility>

#include "solver/app/cell/cell_summary.hpp"
#include "solver/base/error.hpp"

namespace talus::python {

CellScene read_cell_document(const TomlValue& document, const std::string& name) {
  if (!describes_cell(document))
    throw InputError{name + ": cell: it is missing; use talus.Scene for a scene of bodies"};
  return read_cell(document, name, {});
}

ScriptCellRun::ScriptCellRun(const ScriptCell& cell)
    : cell_{cell}, run_{std::make_unique<CellRun>(scene().cell, scene().plan)}, discs_{run_->discs()} {}

CellRun& ScriptCellRun::idle() const {
  demand_idle(is_advancing_);
  return *run_;
}

bool ScriptCellRun::advance(const Advancing& /*advancing*/, long intervals, const std::function<bool()>& interrupted) {
  CellRun& run = *run_;
  bool is_stopped = false;
  while (intervals > 0 && !is_stopped && !run.finished() && run.failure().empty()) {
    run.advance();
    if (run.due()) --intervals;
    is_stopped = interrupted && interrupted();
  }
  show(run.discs());
  return !run.finished() && run.failure().empty();
}

void ScriptCellRun::serialize(Archive& archive) {
  CellRun& run = idle();
  run.serialize(archive);
  std::string failure = run.failure();
  archive.text("failure", failure);
  if (!archive.is_loading()) return;
  run.fail(std::move(failure));
  show(run.discs());
}

void ScriptCellRun::show(const Discs& discs) {
  // Copied, so that arrays of the same size keep their memory: scripts have views of them.
  const auto* const memory = discs_.x.data();
  discs_ = discs;
  TALUS_DEMAND(discs_.x.data() == memory);
}

CellOutcome ScriptCellRun::outcome() const {
  CellRun& run = idle();
  CellOutcome outcome{run.outcome(), {}};
  if (has_ended()) outcome.warnings = app::cell_warnings(scene(), run);
  return outcome;
}

}  // namespace talus::python
