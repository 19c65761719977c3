#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "solver/app/sweep/sweep_result.hpp"
#include "solver/app/sweep/sweep_runs.hpp"
#include "solver/io/scene/scene_file.hpp"
#include "solver/run/quantity.hpp"
#include "solver/scenes/fence_output.hpp"

namespace talus::app {

/// A number that is read of each run: a column of its history, reduced, or a number of a fence's summary.
struct SweepOutput {
  std::string name;
  Dimension dimension{};
  std::variant<Quantity, scenes::FenceOutput> source;
};

/// The scene that the runs of a sweep change, and what is read of each run.
class SweepBase {
 public:
  /// `text`: TOML; `name` is the file named in errors. Errors: InputError for a scene that is wrong, or outputs that it
  /// does not have.
  SweepBase(std::string_view text, std::string name, std::vector<std::string> outputs);
  /// The same of a parsed TOML text.
  SweepBase(TomlValue document, std::string name, std::vector<std::string> outputs);

  /// The outputs of the base, with names and dimensions.
  const std::vector<SweepOutput>& outputs() const { return outputs_; }
  const UnitSystem& units() const { return units_; }
  bool is_fence() const { return is_fence_; }

  /// The scene of one run. Errors: InputError for a wrong field or value.
  [[nodiscard]] SceneFile scene(const SweptRun& run) const;

  /// Executes a run as `talus run` does, without files. `interrupted` is called every 128 steps; if it is
  /// true, the run has no result, and its id is empty.
  [[nodiscard]] SweepResult result(const SweptRun& run, const SweepLimits& limits,
                                   const std::function<bool()>& interrupted) const;

 private:
  std::string name_;
  TomlValue document_;
  std::vector<std::string> names_;
  std::vector<SweepOutput> outputs_;
  UnitSystem units_;
  bool is_fence_{};
};

/// The text of a scene or deck as TOML. Errors: IoError; InputError for a shear cell or a wrong deck.
[[nodiscard]] std::string base_text(const std::filesystem::path& file);

}  // namespace talus::app
