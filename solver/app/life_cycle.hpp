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

/// The life cycle of a run, the same for scenes and cells: it is requested, started in a locked folder or resumed from a
/// checkpoint, advanced with a checkpoint every second, interrupted or ended, and its files are written and named. A
/// command gives its options, reads its scene and implements ResumableRun.
namespace talus::app {

inline constexpr const char* checkpoint_name = "checkpoint.json";

/// What the command line gives to every command that runs a scene file; empty where it gives nothing.
struct RunOptions {
  std::string scene;
  std::string folder;
  std::string resume;
  bool json{false};
};

/// An option by its name, and whether it was given.
using GivenOptions = std::vector<std::pair<const char*, bool>>;

/// A run as the command line requests it: a new one, or one that is resumed.
struct RunRequest {
  std::string command;           ///< "run" or "cell", the only one that resumes it
  std::filesystem::path scene;   ///< its file
  std::string text;              ///< of that file
  std::filesystem::path folder;  ///< locked for the run; empty: nothing is written
  std::filesystem::path from;    ///< folder of the interrupted run; empty for a new run
  Checkpoint saved;              ///< of the interrupted run
  bool json{};

  bool resumes() const { return !from.empty(); }
};

/// The exit code of the run (`ok` or `diverged`) in the folder of --resume, if that run has ended; prints that there is
/// nothing to resume, or with --json its summary. Errors: InputError if one of the options, which need an interrupted
/// run, is given.
[[nodiscard]] std::optional<int> report_ended_run(const RunOptions& options, const GivenOptions& others);

/// The run that the options request, its scene file not yet parsed. `kept`: options that a resumed run keeps from its
/// start. Errors: InputError for options that contradict, a damaged checkpoint, a checkpoint of the other command, and
/// a scene file that was changed; IoError.
[[nodiscard]] RunRequest run_request(std::string_view command, const RunOptions& options, const GivenOptions& kept);

/// The error for an option that a resumed run keeps from its start.
[[nodiscard]] InputError kept_option(std::string_view option);

/// Restores parts of the interrupted run. Errors: InputError that names the checkpoint.
void restore(const RunRequest& request, const std::function<void(Archive&)>& visit);

/// A run between two steps, as the life cycle drives it.
class ResumableRun {
 public:
  using Condition = std::function<bool()>;

  virtual ~ResumableRun() = default;

  /// Names all that the run carries from one step to the next; a run of the same request is resumed from it.
  virtual void serialize(Archive& archive) = 0;
  /// Copies the files that the restored run counts on from the folder of the interrupted run. Errors: IoError.
  virtual void bring_files(const std::filesystem::path& /*from*/) {}
  /// Fills in integrator, tolerance, step, end and steps done.
  virtual void describe(Checkpoint& checkpoint) const = 0;
  /// Whether a checkpoint is written before the first step, because the run may overwrite the file that it starts from.
  virtual bool needs_checkpoint_at_start() const { return false; }

  /// Advances to the end, to the stop time, or until `pause`, if there is one, is true after a step. Errors: IoError.
  virtual Outcome advance(const Condition& pause, Progress& progress) = 0;
  /// Evaluates the run after its last step, and completes the outcome; `interrupted` ends that early. Returns whether
  /// the run can be resumed.
  virtual bool finish(Outcome& outcome, const Condition& interrupted) = 0;
  /// Warnings so far: those known at the start first.
  virtual std::vector<std::string> warnings() const = 0;

  /// After finish(): writes all files but summary.json. Errors: IoError.
  virtual void write() = 0;
  /// After all files were written: draws what is made from them. Errors: IoError.
  virtual void draw() const {}
  /// Names of the files that write() and draw() leave.
  virtual std::vector<std::string> file_names() const = 0;
  /// What --out would write, for a run without a folder.
  virtual std::string files_of_out() const = 0;
  /// Content of summary.json; with `resume`, the command that resumes the run, that too.
  virtual std::string summary_json(const std::string& resume) = 0;
  virtual std::string summary_text() = 0;
};

/// Runs what `make` returns from its start or its checkpoint to its end, and returns the exit code. A folder is locked
/// and emptied of an earlier run before `make` is called. SIGINT, SIGTERM and SIGHUP interrupt a run that has a folder, after
/// its present step. Errors: InputError for a checkpoint that does not fit the run; IoError.
[[nodiscard]] int live(const RunRequest& request, const std::function<std::unique_ptr<ResumableRun>()>& make);

}  // namespace talus::app
