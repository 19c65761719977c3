#include "solver/app/sweep/swept_cell.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "solver/app/cell/cell_summary.hpp"
#include "solver/app/sweep/run_limits.hpp"
#include "solver/base/error.hpp"
#include "solver/io/cell/write_cell.hpp"

namespace talus::app {
namespace {

/// Groups and results of a run; each result is followed by its standard error.
std::vector<std::pair<SweepOutput, double>> numbers_of_cell(const CellScene& scene, CellRun& run) {
  std::vector<std::pair<SweepOutput, double>> numbers;
  for (const CellNumber& group : cell_groups(scene, run))
    numbers.push_back({{"cell." + group.name, group.dimension}, group.estimate.value});
  for (const CellNumber& result : cell_results(run)) {
    numbers.push_back({{"cell." + result.name, result.dimension}, result.estimate.value});
    numbers.push_back({{"cell." + result.name + ".error", result.dimension}, result.estimate.error});
  }
  numbers.push_back({{"cell.balance_error", dimension::number}, run.ledger().relative_balance_error()});
  return numbers;
}

/// The numbers with these names. Errors: InputError for one that the cell does not have.
std::vector<std::pair<SweepOutput, double>> cell_numbers_named(const CellScene& scene, CellRun& run,
                                                               const std::vector<std::string>& names) {
  const std::vector<std::pair<SweepOutput, double>> all = numbers_of_cell(scene, run);
  std::vector<std::pair<SweepOutput, double>> named;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name, [](const auto& of) { return of.first.name; });
    if (found == all.end()) {
      std::vector<std::string> known;
      for (const auto& [output, value] : all)
        known.push_back(output.name);
      throw unknown_name("number of a cell", name, known);
    }
    named.push_back(*found);
  }
  return named;
}

}  // namespace

SweptCell::SweptCell(TomlValue document, std::string name)
    : name_{std::move(name)}, document_{std::move(document)}, base_{read_cell(document_, name_, {})} {}

void SweptCell::choose(std::vector<std::string> outputs) {
  CellRun run{base_.cell, base_.plan};
  outputs_.clear();
  for (auto& [output, value] : cell_numbers_named(base_, run, outputs))
    outputs_.push_back(output);
  names_ = std::move(outputs);
}

CellScene SweptCell::cell(const SweptRun& run) const { return read_cell(with_parameters(document_, run), name_, {}); }

SweepResult SweptCell::result(const SweptRun& run, const SweepLimits& limits,
                              const std::function<bool()>& interrupted) const {
  SweepResult result{run.id, SweepEnd::finished, {}, 0.0, 0, {}, {}};
  std::optional<CellScene> scene;
  std::optional<CellRun> cell_run;
  try {
    scene.emplace(cell(run));
    cell_run.emplace(scene->cell, scene->plan);
    static_cast<void>(cell_numbers_named(*scene, *cell_run, names_));
  } catch (const InputError& error) {
    result.end = SweepEnd::refused, result.reason = error.what();
    return result;
  }
  RunLimits end{limits, interrupted, 1};
  while (!cell_run->finished() && cell_run->failure().empty() && !end.reached(cell_run->evaluations()))
    cell_run->advance();
  if (end.is_interrupted()) return {};
  result.time = cell_run->discs().t;
  result.evaluations = cell_run->evaluations();
  if (!cell_run->failure().empty()) {
    result.end = SweepEnd::diverged, result.reason = cell_run->failure();
    return result;
  }
  if (!cell_run->finished()) {
    result.end = SweepEnd::limited, result.reason = end.reason();
    return result;
  }
  std::vector<std::string> reasons = cell_warnings(*scene, *cell_run);
  for (const auto& [output, value] : cell_numbers_named(*scene, *cell_run, names_)) {
    result.values.push_back(value * si_size(*scene->units, output.dimension) / si_size(units(), output.dimension));
    if (!std::isfinite(value)) reasons.push_back(no_value(output.name, "what it is divided by is 0 in the means"));
  }
  result.reason = fmt::format("{}", fmt::join(reasons, "; "));
  return result;
}

}  // namespace talus::app
