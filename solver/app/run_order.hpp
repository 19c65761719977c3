#pragma once

#include <filesystem>
#include <string>

#include "solver/base/memory.hpp"
#include "solver/io/read_scene_file.hpp"

namespace talus::app {

inline constexpr const char* checkpoint_name = "checkpoint.json";

/// What the command line gives to `talus run`; empty where it says nothing.
struct RunOptions {
  std::string scene;
  std::string folder;
  std::string until;
  std::string resume;
  std::string end;
  std::string step;
  std::string integrator;
  double tolerance{};
  bool json{false};
  bool all{false};  ///< all tables of the summary
  bool sheet{false};
  long frames{};  ///< states of the geometry; 0: as the scene says
};

/// A run as the command line asks for it.
struct RunOrder {
  std::filesystem::path scene;   ///< its file
  std::string text;              ///< of that file
  SceneFile file;                ///< with what the command line changes of it
  std::filesystem::path folder;  ///< empty: nothing is written
  std::filesystem::path from;    ///< folder in which the run stood that is taken on; empty for a new one
  std::filesystem::path name;    ///< of the scene when the run began: names its files
  bool sheet{};                  ///< the engineer's sheet is wanted
  long steps{};                  ///< done where the run stands
  MemoryItems memory;            ///< of the run that is taken on

  std::filesystem::path checkpoint() const { return folder / checkpoint_name; }
};

/// The run that the options ask for: a new one, or one that is taken on as its checkpoint says. Errors: InputError for
/// what does not go together, a checkpoint or a scene that is refused; IoError.
[[nodiscard]] RunOrder run_order(const RunOptions& options);

/// The step after which --until stops the run; the plan's last without it. Errors: InputError for a time that the run
/// has passed or never reaches.
[[nodiscard]] long last_step(const RunOptions& options, const RunOrder& order);

}  // namespace talus::app
