#pragma once

#include <filesystem>
#include <string>

#include "solver/app/life_cycle.hpp"
#include "solver/io/read_scene_file.hpp"

namespace talus::app {

/// What the command line gives to `talus run`; empty where it gives nothing.
struct SceneOptions : RunOptions {
  std::string until;
  std::string end;
  std::string step;
  std::string integrator;
  double tolerance{};
  bool all{false};    ///< all tables of the summary
  bool sheet{false};  ///< the engineer's sheet
  long frames{};      ///< states of the geometry; 0: as the scene says

  /// The options that a resumed run keeps from its start, but --sheet.
  GivenOptions kept() const;
};

/// A scene's run as the command line requests it.
struct SceneRequest {
  RunRequest run;
  SceneFile file;  ///< changed by the options or, of a resumed run, by its checkpoint
  bool sheet{};    ///< the engineer's sheet is wanted

  /// The scene's file when the run was started: names its files.
  std::filesystem::path name() const { return run.resumes() ? std::filesystem::path{run.saved.scene_file} : run.scene; }
};

/// The run that the options request. Errors: as run_request(); InputError for a scene that is refused.
[[nodiscard]] SceneRequest scene_request(const SceneOptions& options);

/// The step after which --until stops the run; the plan's last without it. Errors: InputError for a time that the run
/// has passed or never reaches.
[[nodiscard]] long last_step(const SceneOptions& options, const SceneRequest& request);

}  // namespace talus::app
