#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/io/cell/write_cell.hpp"

namespace talus::app {

/// Output files of a cell's run, except checkpoint and summary; each file is written completely or not at all.
class CellFiles {
 public:
  /// The folder must exist; `scene` must outlive this object. Errors: IoError.
  CellFiles(std::filesystem::path folder, const CellScene& scene);

  /// Sets the number of cycles given by the RESTART.DAT from which the run starts; RESTART.DAT then counts on from it.
  void count_on(long cycles) { cycles_before_ = cycles; }
  /// Call after each LOOP: writes RESTART.DAT, and with pictures PIC.DAT and a state of the series. Errors: IoError.
  void write_loop(CellRun& run);
  /// Call at the end: writes history.csv, profile.csv, the series' index and plot.json. Errors: IoError.
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
