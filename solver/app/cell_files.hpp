#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "solver/io/cell/write_cell.hpp"
#include "solver/io/file/folder_lock.hpp"

namespace talus::app {

/// What a run of a cell leaves in its folder, each file whole or not at all.
class CellFiles {
 public:
  /// Makes the folder and keeps it for this run. Errors: IoError.
  CellFiles(std::filesystem::path folder, const CellScene& scene);

  /// When the run stands: removes the summary of an earlier run, which would vouch for a mixture, and, if no run that
  /// was left there is taken on, its checkpoint and all that an earlier cell wrote but RESTART.DAT; what was being
  /// written when one was killed in any case.
  void begin(bool taken_on) const;

  /// Of a run that goes on from a RESTART.DAT: the cycles that it names.
  void count_on(long cycles) { cycles_before_ = cycles; }
  /// Notes that a state is to be written: before the checkpoint is made, which holds the series so far.
  void begin_loop(double time) { times_.push_back(time); }
  /// After each LOOP: RESTART.DAT, and with pictures PIC.DAT and a state of the series. Errors: IoError.
  void write_loop(CellRun& run);
  /// Whether the last checkpoint is a second old. It holds all LOOPs so far; one behind each would take most of the
  /// time of a run with short ones.
  bool checkpoint_due() const { return Clock::now() >= next_checkpoint_; }
  /// Errors: IoError.
  void write_checkpoint(const std::string& text);
  /// At the end: history.csv, profile.csv, the series' index, plot.json, summary.json last: it says that all is there.
  void write_end(CellRun& run, const CellOutcome& outcome);
  /// Removes the checkpoint of a run that needs it no more, for all else is written.
  void remove_checkpoint() const;

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path checkpoint() const { return folder_ / "checkpoint.json"; }
  /// Names of the files that are written, in their order.
  std::vector<std::string> names() const;

  void remember(Memory& memory) { memory.list("times", times_), memory.count("cycles_before", cycles_before_); }

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path folder_;
  FolderLock lock_;
  const CellScene* scene_;
  std::vector<double> times_;  ///< of the states written so far [T]
  long cycles_before_{};
  Clock::time_point next_checkpoint_{};
};

}  // namespace talus::app
