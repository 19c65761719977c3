#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/io/output/checkpoint.hpp"
#include "solver/run/outcome.hpp"

/// The life cycle of a run, common to scenes and cells: a run is requested, started in a locked folder or resumed from
/// a checkpoint, advanced with a checkpoint every second, interrupted or ended, and its files are written and listed. A
/// command provides its options, reads its scene and implements ResumableRun.
namespace talus::app {

inline constexpr const char* checkpoint_name = "checkpoint.json";

/// Options of every command that runs a scene file; empty if not given.
struct RunOptions {
  std::string scene;
  std::string folder;
  std::string resume;
  bool json{false};
};

/// Names of options, each with whether it was given.
using GivenOptions = std::vector<std::pair<const char*, bool>>;

/// A run requested on the command line: a new run, or one that is resumed.
struct RunRequest {
  std::string command;           ///< "run" or "cell"; only the same command can resume the run
  std::filesystem::path scene;   ///< the scene's file
  std::string text;              ///< content of that file
  std::filesystem::path folder;  ///< locked for the run; empty: nothing is written
  std::filesystem::path from;    ///< folder of the interrupted run; empty for a new run
  Checkpoint saved;              ///< of the interrupted run
  bool json{};

  bool resumes() const { return !from.empty(); }
};

/// The exit status (`ok`, `diverged` or `unusable`) of the run in the folder of --resume if that run has ended, else
/// nothing; prints that there is nothing to resume, or with --json the run's summary. Errors: InputError if one of
/// `others` is given, the options that require an interrupted run.
[[nodiscard]] std::optional<int> report_ended_run(const RunOptions& options, const GivenOptions& others);

/// The run requested by the options, its scene file read but not parsed. `kept`: options that a resumed run keeps from
/// its start. Errors: InputError for contradictory options, a damaged checkpoint, a checkpoint of the other command,
/// and a changed scene file; IoError.
[[nodiscard]] RunRequest run_request(std::string_view command, const RunOptions& options, const GivenOptions& kept);

/// The error for an option that a resumed run keeps from its start.
[[nodiscard]] InputError kept_option(std::string_view option);

/// Restores parts of the interrupted run by visit(archive). Errors: InputError naming the checkpoint.
void restore(const RunRequest& request, const std::function<void(Archive&)>& visit);

/// A run that can be interrupted and resumed between two steps: the interface used by live().
class ResumableRun {
 public:
  using Condition = std::function<bool()>;

  virtual ~ResumableRun() = default;

  /// Saves or restores the complete state of the run; a run of the same request is resumed from it.
  virtual void serialize(Archive& archive) = 0;
  /// Copies the files that the restored run needs from the folder of the interrupted run. Errors: IoError.
  virtual void bring_files(const std::filesystem::path& /*from*/) {}
  /// A time as text with its unit, which a run may lack: "0.25 s".
  virtual std::string time_text(double time) const = 0;
  /// Sets integrator, tolerance, step, end and steps done.
  virtual void describe(Checkpoint& checkpoint) const = 0;
  /// Whether a checkpoint is written before the first step, because the run may overwrite the file that it starts from.
  virtual bool needs_checkpoint_at_start() const { return false; }

  /// Advances to the end, to the stop time, or until `pause` (if set) is true after a step. Errors: IoError.
  virtual Outcome advance(const Condition& pause, Progress& progress) = 0;
  /// Evaluates the run after its last step and completes the outcome; returns early when `interrupted` is true. Returns
  /// whether the run can be resumed.
  virtual bool finish(Outcome& outcome, const Condition& interrupted) = 0;
  /// Whether the ended run may count as done; if not, the exit status is `unusable`.
  virtual bool is_usable() const { return true; }
  /// Warnings so far, beginning with those known at the start.
  virtual std::vector<std::string> warnings() const = 0;

  /// Writes all files except summary.json; called after finish(). Errors: IoError.
  virtual void write() = 0;
  /// Draws the pages made from the files; called after all files were written. Errors: IoError.
  virtual void draw() const {}
  /// Names of the files that write() and draw() create.
  virtual std::vector<std::string> file_names() const = 0;
  /// Description of the files that --out would write, for a run without a folder.
  virtual std::string files_of_out() const = 0;
  /// Content of summary.json; includes `resume`, the command that resumes the run, if it is not empty.
  virtual std::string summary_json(const std::string& resume) = 0;
  virtual std::string summary_text() = 0;
};

/// Executes the run that `make` returns, from its start or checkpoint to its end, and returns the exit status. A folder
/// is locked and the files of an earlier run in it are removed before `make` is called. SIGINT, SIGTERM and SIGHUP
/// interrupt a run that has a folder after its present step. Errors: InputError for a checkpoint that does not fit the
/// run; IoError.
[[nodiscard]] int live(const RunRequest& request, const std::function<std::unique_ptr<ResumableRun>()>& make);

}  // namespace talus::app
