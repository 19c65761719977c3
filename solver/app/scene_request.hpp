#pragma once

#include <filesystem>
#include <string>

#include "solver/app/life_cycle.hpp"
#include "solver/io/read_scene_file.hpp"

namespace talus::app {

/// Options that change the method of a scene; empty or 0 if not given.
struct MethodOptions {
  std::string end;
  std::string step;
  std::string integrator;
  double tolerance{};
};

/// Options of `talus run`; empty if not given.
struct SceneOptions : RunOptions, MethodOptions {
  std::string until;
  bool all{false};      ///< print all tables of the summary
  bool sheet{false};    ///< make the engineer's sheet
  bool impacts{false};  ///< make the table of impacts
  long frames{};        ///< states of the geometry; 0: default of the scene

  /// The options that a resumed run keeps from its start, except --sheet and --impacts.
  GivenOptions kept() const;
};

/// Applies these options to the scene of a new run. Errors: InputError naming the option.
void apply_options(const MethodOptions& options, SceneFile& file);

/// A scene's run requested on the command line.
struct SceneRequest {
  RunRequest run;
  SceneFile file;  ///< with changes by the options or, for a resumed run, by its checkpoint
  bool sheet{};    ///< the engineer's sheet is requested
  bool impacts{};  ///< the table of impacts is requested

  /// The scene's file at the start of the run; output files are named after it.
  std::filesystem::path name() const { return run.resumes() ? std::filesystem::path{run.saved.scene_file} : run.scene; }
};

/// The run requested by the options. Errors: as run_request(); InputError for a scene that is rejected.
[[nodiscard]] SceneRequest scene_request(const SceneOptions& options);

/// The step after which --until stops the run; without --until the plan's last step. Errors: InputError for a time that
/// the run has passed or never reaches.
[[nodiscard]] long last_step(const SceneOptions& options, const SceneRequest& request);

}  // namespace talus::app
