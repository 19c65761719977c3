#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/io/cell/write_cell.hpp"

namespace talus::app {

/// What a run of a cell leaves in its folder besides checkpoint and summary, each file whole or not at all.
class CellFiles {
 public:
  /// The folder must be there. Errors: IoError.
  CellFiles(std::filesystem::path folder, const CellScene& scene);

  /// Of a run that starts from a RESTART.DAT: the cycles that it names.
  void count_on(long cycles) { cycles_before_ = cycles; }
  /// After each LOOP: RESTART.DAT, and with pictures PIC.DAT and a state of the series. Errors: IoError.
  void write_loop(CellRun& run);
  /// At the end: history.csv, profile.csv, the series' index, plot.json. Errors: IoError.
  void write_end(CellRun& run) const;
  /// Names of the files, in the order in which they are written.
  std::vector<std::string> names() const;

  void serialize(Archive& archive) { archive.list("times", times_), archive.count("cycles_before", cycles_before_); }

 private:
  std::filesystem::path folder_;
  const CellScene* scene_;
  std::vector<double> times_;  ///< of the states written so far [T]
  long cycles_before_{};
};

}  // namespace talus::app
