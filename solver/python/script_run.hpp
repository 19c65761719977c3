#pragma once

#include <string>
#include <vector>

#include "solver/python/script_scene.hpp"

namespace talus::python {

/// The results of a run, as a script keeps them.
struct ScriptRun {
  std::vector<std::string> columns;   ///< of the history
  std::vector<std::string> units;     ///< of these columns
  std::vector<double> numbers;        ///< of the history, column by column
  std::string summary;                ///< text of summary.json
  std::string outcome;                ///< "finished" or "diverged"
  bool usable{};                      ///< the results can be used
  std::vector<std::string> warnings;  ///< those that `talus run` prints

  std::size_t rows() const { return columns.empty() ? 0 : numbers.size() / columns.size(); }
};

/// Runs a scene as `talus run` does, without files and without the second run of a fence. Without the interpreter's
/// lock; Ctrl-C raises KeyboardInterrupt. Errors: InputError naming the argument.
[[nodiscard]] ScriptRun run_scene(const ScriptScene& scene, const app::MethodOptions& method);

}  // namespace talus::python
