#include "solver/app/fit/fit_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string_view>

#include "solver/app/sweep/executed_runs.hpp"
#include "solver/app/sweep/sweep_function.hpp"
#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus::app {
namespace {

/// The scene with the results as outputs. Errors: InputError, of a result with its place in the file.
SweepBase base_of(const FitFile& file) {
  const std::string name = file.scene.string();
  SweepBase base{parse_toml(base_text(file.scene, file.file.string() + ": scene"), name), name};
  std::vector<std::string> outputs;
  for (const FitQuantity& quantity : file.quantities) {
    base.choose({quantity.result}, quantity.where + ": result");
    outputs.push_back(quantity.result);
  }
  base.choose(std::move(outputs));
  return base;
}

/// Dimension and SI size of a unit; a pure number without one.
AnyQuantity size_of(const std::string& unit, const std::string& where) {
  if (unit.empty()) return {1.0, dimension::number};
  try {
    return parse_any_quantity("1 " + unit, si);
  } catch (const InputError&) {
    throw InputError{fmt::format("{}: column: '{}' is not a unit; give one, as in \"speed [m/s]\"", where, unit)};
  }
}

}  // namespace

FitStudy::FitStudy(const FitFile& file, unsigned threads) : file_{&file}, threads_{threads}, base_{base_of(file)} {
  for (std::size_t i = 0; i < file.quantities.size(); ++i) {
    const FitQuantity& quantity = file.quantities[i];
    const SweepOutput& output = base_.outputs()[i];
    const AnyQuantity column = size_of(quantity.unit, quantity.where),
                      divisor = size_of(quantity.divisor_unit, quantity.where);
    const Dimension expected = quantity.divisors.empty() ? output.dimension : output.dimension / divisor.dimension;
    if (!(column.dimension == expected)) {
      throw InputError{fmt::format(
          "{}: column: {} is in {}, the column \"{}\" in {}; give the column in the unit of the result", quantity.where,
          quantity.result, symbol(si, expected), quantity.heading, quantity.unit.empty() ? "no unit" : quantity.unit)};
    }
    sources_.push_back({i, si_size(base_.units(), output.dimension) / divisor.value / column.value});
  }
  check_first_row();
}

void FitStudy::check_first_row() const {
  std::vector<double> start;
  std::vector<std::string> locations;
  for (const FitInput& input : file_->inputs)
    locations.push_back(input.where);
  for (const FittedField& field : file_->parameters) {
    start.push_back(field.parameter.start);
    locations.push_back(field.where);
  }
  const SweptRun first = run(start, 0);
  SweptRun tried;
  for (std::size_t i = 0; i < locations.size(); ++i) {
    try {
      tried.parameters.push_back(first.parameters[i]);
      check_fields(base_.document(), tried);
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}: field: {}", locations[i], error.what())};
    }
  }
  try {
    static_cast<void>(base_.end(first));
  } catch (const InputError& error) {
    // Of several values that only together are wrong, the file.
    if (const auto wrong = base_.refused_parameter(first, error.what())) {
      const std::size_t inputs = file_->inputs.size();
      const std::string value = *wrong < inputs                                ? "column: its first value"
                                : file_->parameters[*wrong - inputs].has_start ? "start"
                                                                               : "range: its middle";
      throw InputError{fmt::format("{}: {}, {}: {}", locations[*wrong], value, found(first.parameters[*wrong].second),
                                   error.what())};
    }
    throw InputError{fmt::format("{}: the first row of the data with the parameters at their start: {}",
                                 file_->file.string(), error.what())};
  }
}

SweptRun FitStudy::run(const std::vector<double>& parameters, std::size_t row) const {
  SweptRun run;
  for (const FitInput& input : file_->inputs)
    run.parameters.emplace_back(input.field, value_in(input.values[row], input.unit));
  for (std::size_t i = 0; i < parameters.size(); ++i)
    run.parameters.emplace_back(file_->parameters[i].field, value_in(parameters[i], file_->parameters[i].unit));
  run.id = id_of(run);
  return run;
}

std::vector<double> FitStudy::results(const std::vector<double>& parameters, const std::vector<std::size_t>& rows) {
  const std::size_t width = sources_.size();
  std::vector<double> found(rows.size() * width, std::numeric_limits<double>::quiet_NaN());
  std::vector<std::string> reasons(rows.size());
  const auto result_of = [&](std::size_t i) {
    return base_.result(run(parameters, rows[i]), file_->limits, interrupted_);
  };
  for_each_executed(rows.size(), threads_, interrupted_, result_of, [&](std::size_t i, const SweepResult& result) {
    // Also a run that is not usable has no result, and one without a number that is compared.
    reasons[i] = result.end == SweepEnd::finished ? failure_of(result) : result.reason;
    if (!reasons[i].empty()) return;
    for (std::size_t k = 0; k < width; ++k) {
      const std::vector<double>& divisors = file_->quantities[k].divisors;
      found[i * width + k] =
          result.values[sources_[k].output] * sources_[k].factor / (divisors.empty() ? 1.0 : divisors[rows[i]]);
    }
  });
  if (interrupted_()) throw Interrupted{};
  const auto failed = std::ranges::find_if(reasons, [](const std::string& reason) { return !reason.empty(); });
  if (failed != reasons.end())
    failure_ = fmt::format("row {}: {}", rows[static_cast<std::size_t>(failed - reasons.begin())] + 1, *failed);
  runs_ += rows.size();
  progress_(runs_);
  return found;
}

std::vector<double> FitStudy::results(const std::vector<double>& parameters) {
  std::vector<std::size_t> rows(file_->rows);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return results(parameters, rows);
}

Fit FitStudy::fitted(const std::function<bool()>& interrupted, const std::function<void(std::size_t)>& progress) {
  interrupted_ = interrupted, progress_ = progress;
  std::vector<FitParameter> parameters;
  for (const FittedField& field : file_->parameters)
    parameters.push_back(field.parameter);
  const std::size_t width = sources_.size();
  const FitModel deviations = [&](const std::vector<double>& values, const std::vector<std::size_t>& rows) {
    std::vector<double> found = results(values, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = 0; k < width; ++k) {
        const FitQuantity& quantity = file_->quantities[k];
        found[i * width + k] = (found[i * width + k] - quantity.values[rows[i]]) / quantity.uncertainty.value_or(1.0);
      }
    }
    return found;
  };
  try {
    return fit(parameters, deviations, {.rows = file_->rows, .samples = file_->samples, .seed = file_->seed},
               file_->has_uncertainties());
  } catch (const InputError& error) {
    throw InputError{fmt::format("{}: {}{}", file_->file.string(), error.what(),
                                 failure_.empty() ? "" : fmt::format("; last failure: {}", failure_))};
  }
}

}  // namespace talus::app
