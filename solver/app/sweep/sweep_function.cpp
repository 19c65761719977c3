#include "solver/app/sweep/sweep_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus::app {
namespace {

/// The unit of an axis' field, which all its values have.
std::string unit_of(const SweepAxis& axis, std::size_t field) {
  if (axis.continuous) return axis.continuous->unit;
  std::optional<std::string> unit;
  for (const std::vector<TomlValue>& row : axis.rows) {
    const WrittenNumber number = written_number(row[field]);
    if (unit && *unit != number.unit)
      throw InputError{fmt::format("found values in {} and {}; give all in one unit", *unit, number.unit)};
    unit = number.unit;
  }
  return unit.value_or("");
}

std::vector<SweepInput> inputs_of(const SweepFile& sweep) {
  std::vector<SweepInput> inputs;
  for (const SweepAxis& axis : sweep.axes) {
    if (axis.rows.size() == 1) continue;
    for (std::size_t field = 0; field < axis.fields.size(); ++field) {
      try {
        inputs.push_back({axis.fields[field], unit_of(axis, field)});
      } catch (const InputError& error) {
        throw InputError{fmt::format("axis: '{}': {}", axis.fields[field], error.what())};
      }
    }
  }
  return inputs;
}

SweepBase base_of(const SweepFile& sweep) {
  const std::string name = sweep.base.string();
  SweepBase base{parse_toml(base_text(sweep.base, sweep.base_location()), name), name};
  base.choose(sweep.outputs, sweep.outputs_location());
  return base;
}

}  // namespace

SweepFunction::SweepFunction(const std::filesystem::path& file)
    : sweep_{read_sweep(read_text(file), file)}, base_{base_of(sweep_)}, inputs_{of_file(file, [&] {
        return inputs_of(sweep_);
      })} {
  SweptRun first;
  of_file(file, [&] {
    if (inputs_.empty()) throw InputError{"axis: all have one point; give one with a range or several values"};
    for (const SweepAxis& axis : sweep_.axes) {
      for (std::size_t field = 0; field < axis.fields.size(); ++field) {
        first.parameters.emplace_back(axis.fields[field],
                                      axis.continuous ? axis.continuous->written(0.0) : axis.rows.front()[field]);
        if (axis.rows.size() == 1) fixed_.parameters.push_back(first.parameters.back());
      }
    }
  });
  base_.check_axes(sweep_, first);
}

std::string SweepFunction::unit(const SweepOutput& output) const {
  return output.dimension == dimension::number ? "" : symbol(base_.units(), output.dimension);
}

SweepResult SweepFunction::operator()(std::span<const double> numbers, const std::function<bool()>& interrupted) const {
  TALUS_DEMAND(numbers.size() == inputs_.size());
  SweptRun run = fixed_;
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    run.parameters.emplace_back(inputs_[i].field, value_in(numbers[i], inputs_[i].unit));
  run.id = id_of(run);
  if (const auto broken = broken_constraint(run, sweep_)) {
    return {run.id, SweepEnd::refused, fmt::format("constraint {}: it is not satisfied", *broken + 1), 0.0, 0, {}, {}};
  }
  return base_.result(run, sweep_.limits, interrupted);
}

std::string failure_of(const SweepResult& result) {
  if (result.end != SweepEnd::finished) {
    return fmt::format("{}: {}", name_of(result.end), result.reason);
  }
  const bool has_all = std::ranges::all_of(result.values, [](double value) { return std::isfinite(value); });
  return has_all ? "" : result.reason;
}

}  // namespace talus::app
