#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/app/sweep/scene_numbers.hpp"
#include "solver/app/sweep/sweep_result.hpp"
#include "solver/app/sweep/sweep_runs.hpp"
#include "solver/io/scene/scene_file.hpp"

namespace talus::app {

/// A scene of bodies as the base of a sweep. Outputs: see SceneNumbers.
class SweptScene {
 public:
  /// Errors: InputError for a scene that is wrong.
  SweptScene(TomlValue document, std::string name);

  /// See SweepBase::choose().
  void choose(std::vector<std::string> outputs);

  const TomlValue& document() const { return document_; }
  const std::vector<SweepOutput>& outputs() const { return outputs_; }
  const UnitSystem& units() const { return base_.scene.model.units; }
  bool is_fence() const { return base_.fence.has_value(); }
  /// Time at which a run is planned to end [T]. Errors: InputError for a wrong field or value.
  [[nodiscard]] double end(const SweptRun& run) const { return scene(run).scene.plan.end; }
  /// See SweepBase::result(). Warnings of `talus run` are the reason of a run that finished.
  [[nodiscard]] SweepResult result(const SweptRun& run, const SweepLimits& limits,
                                   const std::function<bool()>& interrupted) const;

 private:
  [[nodiscard]] SceneFile scene(const SweptRun& run) const;

  std::string name_;
  TomlValue document_;
  SceneFile base_;
  std::vector<std::string> names_;
  std::vector<SweepOutput> outputs_;
};

}  // namespace talus::app
