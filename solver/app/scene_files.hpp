#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/app/fence_files.hpp"
#include "solver/io/output/run_folder.hpp"
#include "solver/io/output/write_geometry.hpp"
#include "solver/io/read_scene_file.hpp"

namespace talus::app {

/// Steps from one state of the geometry to the next; see SceneFiles for `frames`.
[[nodiscard]] long steps_between_states(const SceneFile& file, long frames);

/// The files that a run leaves beside its records while it goes on, named after the scene's file: the geometry NAME.pvd
/// with NAME_geometry/, and of a fence the files of 1993 too.
class SceneFiles {
 public:
  /// `frames` states of the geometry, evenly over the run; 0: a fence's every nprint steps, else 100. Arguments must
  /// outlive it. Errors: InputError, which names the scene's file; IoError.
  SceneFiles(const SceneFile& file, const Dynamics& dynamics, const std::filesystem::path& folder,
             const std::filesystem::path& scene, long frames);

  void operator()(const Snapshot& snapshot, const StepInfo& info);
  /// Writes what is not yet written. Errors: IoError.
  void write() const;

  /// Names what the files carry from one step to the next; those of the same run go on from it.
  void remember(Memory& memory);
  /// After they were put back: brings what was written to the folder in which the run stood. Errors: IoError.
  void bring_files(const std::filesystem::path& from) { geometry_.bring_files(from); }

  /// Names of the files, for the summary.
  std::vector<std::string> names() const;
  /// Histories that were asked for and do not exist, in words.
  std::vector<std::string> left_out() const;
  /// What pictures are drawn from; "history.csv" among it.
  RunFiles drawn_from() const;

 private:
  std::vector<DrawnBody> drawn_bodies() const;

  const SceneFile* file_;
  std::string name_;
  std::optional<FenceFiles> of_fence_;
  VtpSeries geometry_;
};

}  // namespace talus::app
