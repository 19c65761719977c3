#pragma once

#include "solver/run/history.hpp"
#include "solver/run/quantity.hpp"
#include "verification/study/runs/scene_run.hpp"

namespace talus::verification::problems {

/// A scene run with its method and plan while its history is recorded, as `talus run` does.
class RecordedRun {
 public:
  /// `watch` also receives the states.
  RecordedRun(const Scene& scene, Findings& findings, const Watcher& watch = {})
      : dynamics_{scene.model},
        recorder_{dynamics_, first_state(scene), scene.plan.ledger},
        end_{run_scene(scene, findings, [&](const Snapshot& seen, const StepInfo& info) {
          recorder_(seen, info);
          if (watch) watch(seen, info);
        })} {}
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  [[nodiscard]] const RunEnd& end() const { return end_; }
  [[nodiscard]] const Recorder& recorder() const { return recorder_; }
  /// Value that a run prints for a quantity.
  [[nodiscard]] double value(const Quantity& quantity) const {
    const Extreme extreme = recorder_.extreme(quantity.column);
    return quantity.of(extreme.minimum, extreme.maximum, recorder_.row()[quantity.column]);
  }

 private:
  Dynamics dynamics_;
  Recorder recorder_;
  RunEnd end_;
};

}  // namespace talus::verification::problems
