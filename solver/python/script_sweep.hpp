#pragma once

#include <string>
#include <variant>
#include <vector>

#include "solver/app/sweep/sweep_base.hpp"
#include "solver/python/script_cell.hpp"
#include "solver/python/script_scene.hpp"

namespace talus::python {

/// The runs that a sweep's file describes.
struct PlannedSweep {
  std::variant<ScriptScene, ScriptCell> base;
  std::vector<app::SweptRun> runs;
  std::vector<std::string> outputs;
  app::SweepLimits limits;
};
/// Reads the file of a sweep and plans its runs, as `talus sweep plan` does. Errors: InputError, IoError.
[[nodiscard]] PlannedSweep plan_sweep(const std::string& file);

/// Limits of the runs of a sweep, and the threads that execute them.
struct SweepArguments {
  std::vector<std::string> outputs;
  app::SweepLimits limits;
  unsigned threads{};  ///< 0: as many as the machine has
};

/// The results of a sweep, one for each run, in their order.
struct ScriptSweep {
  std::vector<std::string> outputs;
  bool is_fence{};
  std::vector<app::SweepResult> results;
};

/// Runs a scene or cell with each of these changes, as `talus sweep run` does, on threads. Without the interpreter's
/// lock; Ctrl-C raises KeyboardInterrupt. The results are the same for any number of threads. Errors: InputError for
/// outputs that the scene does not have; of a run they are its result.
[[nodiscard]] ScriptSweep sweep_document(const TomlValue& document, const std::string& name,
                                         const std::vector<FieldValues>& runs, const SweepArguments& arguments);

}  // namespace talus::python
