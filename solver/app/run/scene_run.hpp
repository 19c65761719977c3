#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/app/outputs/run_outputs.hpp"
#include "solver/app/run/step_parts.hpp"
#include "solver/base/progress.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/io/output/run_record.hpp"
#include "solver/run/history.hpp"
#include "solver/run/run_state.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "solver/stability/run_monitor.hpp"

namespace talus::app {

/// A scene's run with its output files. It can be interrupted between two steps and resumed by another process.
class SceneRun {
 public:
  /// With an empty `folder` nothing is written. `scene` is the scene's file, after which output files are named.
  /// `recorded`: see Recorder; record() and parts() need all columns, and record() all results of a fence. `file` must
  /// outlive this object.
  /// Errors: InputError with the scene's file; IoError.
  SceneRun(const SceneFile& file, const std::filesystem::path& folder, const std::filesystem::path& scene,
           const OutputOptions& options, RecordedColumns recorded = {},
           scenes::FenceResults of_fence = scenes::FenceResults::all);

  /// Saves or restores the complete state of the run; a run of the same scene continues from it.
  void serialize(Archive& archive);
  /// Copies the files written so far from the folder of the interrupted run; called after restoring. Errors: IoError.
  void bring_files(const std::filesystem::path& from);

  /// Advances the run to its plan's end, to the early end of the scene or until `stop`, and shows the progress, if
  /// there is a line for it. `more` observes the steps after the run's own observers. Errors: IoError.
  Outcome proceed(const StopCondition& stop, Progress* progress, const Observer& more = {});
  /// The outcome; of a run that diverged with its step over the linear limit, where the monitor has not said so.
  [[nodiscard]] Outcome explained(Outcome outcome) const;
  /// Whether the run has reached the early end of its scene.
  bool ends_early() const { return ends_early_; }
  /// The monitor of the run, with its results so far.
  const RunMonitor& watch() const { return watch_; }
  /// Warnings about a start that is probably not intended; the first ones of warnings().
  [[nodiscard]] std::vector<std::string> start_warnings() const;
  /// Warnings about the run so far.
  [[nodiscard]] std::vector<std::string> warnings() const;

  const RunState& run_state() const { return run_state_; }
  const Dynamics& dynamics() const { return dynamics_; }
  /// Counts and computing times of the steps of this process. All columns must be recorded.
  [[nodiscard]] StepParts::Found parts() const;
  const Recorder& recorder() const { return recorder_; }
  /// Quality of the results of a run with this outcome.
  [[nodiscard]] RunQuality quality(const Outcome& outcome) const;
  /// Results of a fence so far; null for other scenes.
  const scenes::FenceSummary* fence() const { return fence_ ? &fence_->summary() : nullptr; }
  /// The record of the run, for reports.
  [[nodiscard]] RunRecord record(Outcome outcome) const;
  /// Writes all files except summary.json. Errors: IoError.
  void write(const RunRecord& record) const { outputs_.write({record, seen_, fence_ ? &*fence_ : nullptr}); }
  /// Names of the files that write() creates.
  std::vector<std::string> file_names() const { return outputs_.files(); }

 private:
  State started(State state);

  const SceneFile* file_;
  const Scene* scene_;
  std::filesystem::path folder_;
  Dynamics dynamics_;
  RigidBodySystem system_;
  RunState run_state_;
  Snapshot seen_;                  ///< of the last step
  std::string integrator_reason_;  ///< reason for the integrator; of the interrupted run if resumed, else of the scene
  Recorder recorder_;
  FailureLog failures_;
  RunMonitor watch_;
  std::vector<std::string> overlap_warnings_;  ///< about overlaps of contacts at the start
  RunOutputs outputs_;
  std::optional<scenes::FenceMonitor> fence_;  ///< only for a fence
  bool sheet_{};
  bool ends_early_{};
  std::optional<StepParts> parts_;  ///< only with all columns: one of many runs has no profile
};

}  // namespace talus::app
