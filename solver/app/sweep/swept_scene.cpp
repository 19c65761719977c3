#include "solver/app/sweep/swept_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "solver/app/run/scene_run.hpp"
#include "solver/app/sweep/run_limits.hpp"
#include "solver/base/error.hpp"
#include "solver/io/scene/read_scene.hpp"

namespace talus::app {
namespace {

/// Steps between two readings of the clock and of the signal: some 100 us.
constexpr long stride = 128;

/// Only the first and the last state are stored as rows; extremes are those of all steps.
void drop_history(SceneFile& file) { file.scene.plan.interval = file.scene.plan.end; }

}  // namespace

SweptScene::SweptScene(TomlValue document, std::string name)
    : name_{std::move(name)}, document_{std::move(document)}, base_{read_scene_file(document_, name_)} {}

void SweptScene::choose(std::vector<std::string> outputs) {
  outputs_ = SceneNumbers{base_, outputs}.outputs();
  names_ = std::move(outputs);
}

SceneFile SweptScene::scene(const SweptRun& run) const {
  return read_scene_file(with_parameters(document_, run), name_);
}

SweepResult SweptScene::result(const SweptRun& run, const SweepLimits& limits,
                               const std::function<bool()>& interrupted) const {
  SweepResult result{run.id, SweepEnd::finished, {}, 0.0, 0, {}, {}};
  std::optional<SceneFile> file;
  std::optional<SceneNumbers> numbers;
  try {
    file.emplace(scene(run));
    numbers.emplace(*file, names_);
    drop_history(*file);
  } catch (const InputError& error) {
    result.end = SweepEnd::refused, result.reason = error.what();
    return result;
  }
  const UnitSystem& units = file->scene.model.units;
  SceneRun scene_run{*file, {}, name_, {}, numbers->columns(), numbers->of_fence()};
  RunLimits end{limits, interrupted, stride};
  Outcome outcome = scene_run.proceed([&](const State&) { return end.reached(scene_run.run_state().evaluations); },
                                      nullptr, numbers->observer(scene_run));
  if (end.is_interrupted()) return {};
  result.time = outcome.time;
  result.evaluations = scene_run.run_state().evaluations;
  if (const scenes::FenceSummary* const fence = scene_run.fence()) result.verdict = name_of(fence->verdict());
  if (!outcome) {
    result.end = SweepEnd::diverged, result.reason = scene_run.explained(outcome).message;
    return result;
  }
  if (outcome.kind == Outcome::Kind::stopped) {
    result.end = SweepEnd::limited, result.reason = end.reason();
    return result;
  }
  std::vector<std::string> reasons;
  const RunQuality quality = scene_run.quality(outcome);
  if (!quality.flaw.empty()) {
    if (quality.enforced) result.end = SweepEnd::unusable;
    reasons.push_back(quality.flaw);
  }
  std::ranges::move(scene_run.warnings(), std::back_inserter(reasons));
  result.values = numbers->values(scene_run, reasons);
  result.reason = fmt::format("{}", fmt::join(reasons, "; "));
  for (std::size_t i = 0; i < outputs_.size(); ++i)
    result.values[i] *= si_size(units, outputs_[i].dimension) / si_size(this->units(), outputs_[i].dimension);
  return result;
}

}  // namespace talus::app
