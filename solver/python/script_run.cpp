#include "solver/python/script_run.hpp"

#include "solver/app/run/scene_run.hpp"
#include "solver/app/run/start_warnings.hpp"
#include "solver/io/output/write_summary.hpp"
#include "solver/python/python_signals.hpp"

namespace talus::python {
namespace {

ScriptRun kept(const RunRecord& record) {
  ScriptRun run;
  const History& history = record.history;
  for (const Column& column : history.columns) {
    run.columns.push_back(column.name);
    run.units.push_back(symbol(record.units, column.dimension));
  }
  const std::size_t rows = history.rows.size();
  run.numbers.resize(run.columns.size() * rows);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < run.columns.size(); ++column)
      run.numbers[column * rows + row] = history.rows[row][column];
  run.summary = summary_json(record);
  run.outcome = record.outcome ? "finished" : "diverged";
  run.usable = record.quality.flaw.empty();
  run.warnings = record.warnings;
  return run;
}

}  // namespace

ScriptRun run_scene(const ScriptScene& scene, const app::MethodOptions& method) {
  const SceneFile file = with_method(scene, method);
  PythonSignals signals;
  ScriptRun kept_run;
  {
    const Unlocked unlocked;
    app::SceneRun run{file, {}, scene.name(), {}};
    const bool is_beyond = run.watch().step_is_beyond();
    const Outcome outcome = run.proceed([&](const Snapshot&) { return signals.pending(); }, nullptr);
    kept_run = kept(run.record(run.explained(outcome)));
    if (is_beyond) {
      kept_run.warnings.insert(kept_run.warnings.begin(),
                               app::step_warning(run.watch().step_ratio(), "scene.run(integrator='auto')"));
    }
  }
  signals.rethrow();
  return kept_run;
}

}  // namespace talus::python
