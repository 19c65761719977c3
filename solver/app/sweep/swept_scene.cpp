#include "solver/app/sweep/swept_scene.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <variant>

#include "solver/app/run/scene_run.hpp"
#include "solver/app/sweep/run_limits.hpp"
#include "solver/base/error.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "solver/run/quantity.hpp"
#include "solver/scenes/fence_output.hpp"

namespace talus::app {
namespace {

/// Steps between two readings of the clock and of the signal: some 100 us.
constexpr long stride = 128;

/// Where an output is found.
struct SceneNumber {
  SweepOutput output;
  std::variant<Quantity, scenes::FenceOutput> source;
};

SceneNumber scene_number(const SceneFile& file, const std::string& name) {
  if (file.fence && name.starts_with("fence.")) {
    std::vector<std::string> known;
    for (const scenes::FenceOutput& output : scenes::fence_outputs()) {
      if (output.name == name) return {{name, output.dimension}, output};
      known.emplace_back(output.name);
    }
    throw unknown_name("number of a fence", name, known);
  }
  const Quantity quantity = quantity_named(file.scene.model, name);
  if (quantity.ledger && !file.scene.plan.ledger)
    throw InputError{fmt::format("'{}' needs the energy balance, which the scene switches off", name)};
  return {{name, quantity.dimension}, quantity};
}

/// Errors: InputError for an output that the scene does not have.
std::vector<SceneNumber> numbers_of_scene(const SceneFile& file, const std::vector<std::string>& names) {
  std::vector<SceneNumber> sources;
  for (const std::string& name : names) {
    try {
      sources.push_back(scene_number(file, name));
    } catch (const InputError& error) {
      throw InputError{fmt::format("outputs: {}", error.what())};
    }
  }
  return sources;
}

/// The value of an output at the end of a run, in units of its scene.
double value_of(const SceneNumber& output, const SceneRun& run) {
  if (const auto* const of_fence = std::get_if<scenes::FenceOutput>(&output.source)) return of_fence->of(*run.fence());
  const auto& quantity = std::get<Quantity>(output.source);
  const Extreme extreme = run.recorder().extremes()[quantity.column];
  return quantity.of(extreme.minimum, extreme.maximum, run.recorder().row()[quantity.column]);
}

/// Only the first and the last state are stored as rows; extremes are those of all steps.
void drop_history(SceneFile& file) { file.scene.plan.interval = file.scene.plan.end; }

}  // namespace

SweptScene::SweptScene(TomlValue document, std::string name, std::vector<std::string> outputs)
    : name_{std::move(name)}, document_{std::move(document)}, names_{std::move(outputs)} {
  const SceneFile file = read_scene_file(document_, name_);
  for (SceneNumber& number : numbers_of_scene(file, names_))
    outputs_.push_back(std::move(number.output));
  units_ = file.scene.model.units;
  is_fence_ = file.fence.has_value();
}

SceneFile SweptScene::scene(const SweptRun& run) const {
  return read_scene_file(with_parameters(document_, run), name_);
}

SweepResult SweptScene::result(const SweptRun& run, const SweepLimits& limits,
                               const std::function<bool()>& interrupted) const {
  SweepResult result{run.id, SweepEnd::finished, {}, 0.0, 0, {}, {}};
  std::optional<SceneFile> file;
  std::vector<SceneNumber> wanted;
  try {
    file.emplace(scene(run));
    wanted = numbers_of_scene(*file, names_);
    drop_history(*file);
  } catch (const InputError& error) {
    result.end = SweepEnd::refused, result.reason = error.what();
    return result;
  }
  const UnitSystem& units = file->scene.model.units;
  SceneRun scene_run{*file, {}, name_, {}};
  RunLimits end{limits, interrupted, stride};
  Outcome outcome =
      scene_run.proceed([&](const State&) { return end.reached(scene_run.run_state().evaluations); }, nullptr);
  if (end.is_interrupted()) return {};
  result.time = outcome.time;
  result.evaluations = scene_run.run_state().evaluations;
  if (const scenes::FenceSummary* const fence = scene_run.fence())
    result.verdict = Names<scenes::Verdict>::list[static_cast<std::size_t>(fence->verdict())];
  if (!outcome) {
    result.end = SweepEnd::diverged, result.reason = outcome.message;
    return result;
  }
  if (outcome.kind == Outcome::Kind::stopped) {
    result.end = SweepEnd::limited, result.reason = end.reason();
    return result;
  }
  const RunQuality quality = scene_run.quality(outcome);
  if (quality.enforced && !quality.flaw.empty()) result.end = SweepEnd::unusable, result.reason = quality.flaw;
  for (const SceneNumber& source : wanted)
    result.values.push_back(value_of(source, scene_run) * si_size(units, source.output.dimension) /
                            si_size(units_, source.output.dimension));
  return result;
}

}  // namespace talus::app
