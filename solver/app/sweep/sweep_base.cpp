#include "solver/app/sweep/sweep_base.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <utility>

#include "solver/app/run/scene_run.hpp"
#include "solver/base/error.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "solver/io/fence_file.hpp"
#include "solver/io/file/toml_field.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "solver/io/scene/write_fence.hpp"

namespace talus::app {
namespace {

using Clock = std::chrono::steady_clock;

/// Steps between two readings of the clock and of the signal: some 100 us.
constexpr long stride = 128;

SweepOutput output_named(const SceneFile& file, const std::string& name) {
  if (file.fence && name.starts_with("fence.")) {
    std::vector<std::string> known;
    for (const scenes::FenceOutput& output : scenes::fence_outputs()) {
      if (output.name == name) return {name, output.dimension, output};
      known.emplace_back(output.name);
    }
    throw unknown_name("number of a fence", name, known);
  }
  const Quantity quantity = quantity_named(file.scene.model, name);
  if (quantity.ledger && !file.scene.plan.ledger)
    throw InputError{fmt::format("'{}' needs the energy balance, which the scene switches off", name)};
  return {name, quantity.dimension, quantity};
}

/// Errors: InputError for an output that the scene does not have.
std::vector<SweepOutput> outputs_named(const SceneFile& file, const std::vector<std::string>& names) {
  std::vector<SweepOutput> outputs;
  for (const std::string& name : names) {
    try {
      outputs.push_back(output_named(file, name));
    } catch (const InputError& error) {
      throw InputError{fmt::format("outputs: {}", error.what())};
    }
  }
  return outputs;
}

/// The value of an output at the end of a run, in units of its scene.
double value_of(const SweepOutput& output, const SceneRun& run) {
  if (const auto* const of_fence = std::get_if<scenes::FenceOutput>(&output.source)) return of_fence->of(*run.fence());
  const auto& quantity = std::get<Quantity>(output.source);
  const Extreme extreme = run.recorder().extremes()[quantity.column];
  return quantity.of(extreme.minimum, extreme.maximum, run.recorder().row()[quantity.column]);
}

/// Only the first and the last state are stored as rows; extremes are those of all steps.
void drop_history(SceneFile& file) { file.scene.plan.interval = file.scene.plan.end; }

}  // namespace

SweepBase::SweepBase(std::string_view text, std::string name, std::vector<std::string> outputs)
    : SweepBase{parse_toml(text, name), name, std::move(outputs)} {}

SweepBase::SweepBase(TomlValue document, std::string name, std::vector<std::string> outputs)
    : name_{std::move(name)}, document_{std::move(document)}, names_{std::move(outputs)} {
  const SceneFile file = read_scene_file(document_, name_);
  outputs_ = outputs_named(file, names_);
  units_ = file.scene.model.units;
  is_fence_ = file.fence.has_value();
}

SceneFile SweepBase::scene(const SweptRun& run) const {
  TomlValue document = document_;
  for (const auto& [field, value] : run.parameters)
    set_field(document, field, value);
  return read_scene_file(document, name_);
}

SweepResult SweepBase::result(const SweptRun& run, const SweepLimits& limits,
                              const std::function<bool()>& interrupted) const {
  SweepResult result{run.id, SweepEnd::finished, {}, 0.0, 0, {}, {}};
  std::optional<SceneFile> file;
  std::vector<SweepOutput> wanted;
  try {
    file.emplace(scene(run));
    wanted = outputs_named(*file, names_);
    drop_history(*file);
  } catch (const InputError& error) {
    result.end = SweepEnd::refused, result.reason = error.what();
    return result;
  }
  const UnitSystem& units = file->scene.model.units;
  SceneRun scene_run{*file, {}, name_, {}};
  const Clock::time_point start = Clock::now();
  std::string limit;
  bool is_interrupted = false;
  long step = 0;
  const auto ends = [&](const State&) {
    if (limits.evaluations > 0 && scene_run.run_state().evaluations >= limits.evaluations)
      limit = fmt::format("limit of {} evaluations", limits.evaluations);
    if (++step % stride == 0) {
      is_interrupted = interrupted();
      if (limits.time > 0.0 && std::chrono::duration<double>(Clock::now() - start).count() > limits.time)
        limit = fmt::format("limit of {} s", limits.time);
    }
    return is_interrupted || !limit.empty();
  };
  Outcome outcome = scene_run.proceed(ends, nullptr);
  if (is_interrupted) return {};
  result.time = outcome.time;
  result.evaluations = scene_run.run_state().evaluations;
  if (const scenes::FenceSummary* const fence = scene_run.fence())
    result.verdict = Names<scenes::Verdict>::list[static_cast<std::size_t>(fence->verdict())];
  if (!outcome) {
    result.end = SweepEnd::diverged, result.reason = outcome.message;
    return result;
  }
  if (outcome.kind == Outcome::Kind::stopped) {
    result.end = SweepEnd::limited, result.reason = limit;
    return result;
  }
  const RunQuality quality = scene_run.quality(outcome);
  if (quality.enforced && !quality.flaw.empty()) result.end = SweepEnd::unusable, result.reason = quality.flaw;
  for (const SweepOutput& output : wanted)
    result.values.push_back(value_of(output, scene_run) * si_size(units, output.dimension) /
                            si_size(units_, output.dimension));
  return result;
}

std::string base_text(const std::filesystem::path& file) {
  if (!is_deck(file)) return read_text(file);
  if (describes_cell(file)) throw InputError{file.string() + ": a shear cell is run by `talus cell`"};
  return write_fence(read_deck(file));
}

}  // namespace talus::app
