#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/app/outputs/run_outputs.hpp"
#include "solver/app/step_parts.hpp"
#include "solver/base/progress.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/io/output/run_record.hpp"
#include "solver/run/history.hpp"
#include "solver/run/run_state.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "solver/stability/run_monitor.hpp"

namespace talus::app {

/// A scene's run with all that it leaves in a folder, which can be interrupted between two steps and resumed by another.
class SceneRun {
 public:
  /// `folder` empty: nothing is written. `scene` is its file, whose name others take; `frames` and `sheet`: see
  /// OutputRequest. The scene must outlive it. Errors: InputError, which names the scene's file; IoError.
  SceneRun(const SceneFile& file, const std::filesystem::path& folder, const std::filesystem::path& scene, long frames,
           bool sheet);

  /// Names all that the run carries from one step to the next; a run of the same scene goes on from it.
  void serialize(Archive& archive);
  /// After it was put back: brings what was written to the folder in which the run stood. Errors: IoError.
  void bring_files(const std::filesystem::path& from);

  /// Takes the run on to its plan's end or until `stop`, and shows how far it is. Errors: IoError.
  Outcome proceed(const StopCondition& stop, Progress& progress);
  /// What was watched so far.
  const RunMonitor& watch() const { return watch_; }
  /// What is unlikely to be meant at the start: the first warnings of the record.
  const std::vector<std::string>& start_warnings() const { return start_warnings_; }

  const RunState& run_state() const { return run_state_; }
  const Dynamics& dynamics() const { return dynamics_; }
  /// What its steps carried and cost in this process.
  [[nodiscard]] StepParts::Found parts() const { return parts_.found(); }
  /// The run as it is reported.
  [[nodiscard]] RunRecord record(Outcome outcome) const;
  /// Writes all files but summary.json. Errors: IoError.
  void write(const RunRecord& record) const { outputs_.write({record, seen_, fence_ ? &*fence_ : nullptr}); }
  /// Names of the files that write() leaves.
  std::vector<std::string> file_names() const { return outputs_.files(); }

 private:
  State begun(State state);
  RunQuality quality(const Outcome& outcome) const;

  const SceneFile* file_;
  const Scene* scene_;
  std::filesystem::path folder_;
  Dynamics dynamics_;
  RigidBodySystem system_;
  RunState run_state_;
  Snapshot seen_;               ///< of the last step
  std::string integrator_why_;  ///< the scene's, or that of the resumed run
  Recorder recorder_;
  FailureLog failures_;
  RunMonitor watch_;
  std::vector<std::string> start_warnings_;
  RunOutputs outputs_;
  std::optional<scenes::FenceMonitor> fence_;  ///< of a fence
  bool sheet_{};
  StepParts parts_;
};

}  // namespace talus::app
