#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/io/fence1993/out_listing.hpp"
#include "solver/io/output/fence_history.hpp"
#include "solver/io/read_scene_file.hpp"

namespace talus::app {

/// The files that a fence's run leaves beside those of every run: the listing NAME.OUT, and the deck's histories
/// NAME.history.csv and NAME.history.json.
class FenceFiles {
 public:
  /// Arguments must outlive it. Errors: InputError for history codes that are none; IoError.
  FenceFiles(const FenceInput& input, const RunPlan& plan, const Dynamics& dynamics,
             const std::filesystem::path& folder, const std::string& name);

  void operator()(const Snapshot& snapshot, const StepInfo& info);
  /// Writes what is not yet written. Errors: IoError.
  void write() const;

  /// Names what the files carry from one step to the next; those of the same run go on from it.
  void remember(Memory& memory);

  /// Names of the files, for the summary.
  std::vector<std::string> names() const;
  /// Histories that were asked for and do not exist, in words.
  const std::vector<std::string>& left_out() const { return history_.left_out(); }

 private:
  std::filesystem::path folder_;
  std::string name_;
  FenceHistory history_;
  OutListing listing_;
};

}  // namespace talus::app
