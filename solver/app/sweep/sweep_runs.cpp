#include "solver/app/sweep/sweep_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "solver/app/sweep/design.hpp"
#include "solver/base/error.hpp"
#include "solver/base/units.hpp"
#include "solver/io/file/toml_field.hpp"
#include "solver/io/output/checkpoint.hpp"
#include "verification/record/json_fault.hpp"
#include "verification/record/json_node.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

std::size_t grid_size(const SweepAxis& axis) {
  return axis.continuous ? static_cast<std::size_t>(axis.continuous->count) : axis.rows.size();
}

/// Point `i` of an axis of a grid: of a range with both ends, of quantiles in the middle of equally probable parts.
void add_grid_point(const SweepAxis& axis, std::size_t i, SweptRun& run) {
  if (!axis.continuous) {
    for (std::size_t field = 0; field < axis.fields.size(); ++field)
      run.parameters.emplace_back(axis.fields[field], axis.rows[i][field]);
    return;
  }
  const auto number = static_cast<double>(i), count = static_cast<double>(axis.continuous->count);
  const double probability = axis.continuous->is_range ? number / (count - 1.0) : (number + 0.5) / count;
  run.parameters.emplace_back(axis.fields.front(), axis.continuous->written(probability));
}

std::vector<SweptRun> grid(const SweepFile& sweep) {
  std::size_t count = 1;
  for (const SweepAxis& axis : sweep.axes)
    count *= grid_size(axis);
  std::vector<SweptRun> runs(count);
  for (std::size_t number = 0; number < count; ++number) {
    std::size_t rest = count, left = number;
    for (const SweepAxis& axis : sweep.axes) {
      rest /= grid_size(axis);
      add_grid_point(axis, left / rest, runs[number]);
      left %= rest;
    }
  }
  return runs;
}

std::vector<SweptRun> sampled(const SweepFile& sweep) {
  std::vector<SweptRun> runs;
  for (const std::vector<double>& point : design_points(sweep.design, sweep.axes.size())) {
    SweptRun run;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i) {
      const SweepAxis& axis = sweep.axes[i];
      if (axis.continuous) {
        run.parameters.emplace_back(axis.fields.front(), axis.continuous->written(point[i]));
      } else {
        const auto row = static_cast<std::size_t>(point[i] * static_cast<double>(axis.rows.size()));
        add_grid_point(axis, std::min(row, axis.rows.size() - 1), run);
      }
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

AnyQuantity quantity_of(const TomlValue& value, const std::string& what) {
  try {
    if (const auto* text = std::get_if<std::string>(&value.data)) return parse_any_quantity(*text, si);
    return {written_number(value).value, dimension::number};
  } catch (const InputError& error) {
    throw InputError{fmt::format("'{}': {}", what, error.what())};
  }
}

const TomlValue& value_of(const SweptRun& run, const std::string& field) {
  const auto found = std::ranges::find(run.parameters, field, &std::pair<std::string, TomlValue>::first);
  TALUS_DEMAND(found != run.parameters.end());
  return found->second;
}

/// A limit that a value meets but for round-off is met.
constexpr double round_off = 4.0 * std::numeric_limits<double>::epsilon();

bool satisfies(const SweptRun& run, const SweepConstraint& constraint) {
  const AnyQuantity left = quantity_of(value_of(run, constraint.field), constraint.field);
  const AnyQuantity right = constraint.other.empty() ? quantity_of(constraint.value, found(constraint.value))
                                                     : quantity_of(value_of(run, constraint.other), constraint.other);
  if (left.dimension != right.dimension) {
    throw InputError{fmt::format("'{}' is {}, and {} is {}; give values of one dimension", constraint.field,
                                 text_of(left.dimension), found(constraint.value), text_of(right.dimension))};
  }
  const double limit = constraint.factor * right.value, margin = round_off * std::abs(limit);
  return constraint.is_upper ? left.value <= limit + margin : left.value >= limit - margin;
}

Json json_of(const TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
  if (const auto* number = std::get_if<double>(&value.data)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return *whole;
  return std::get<bool>(value.data);
}

TomlValue value_of(const Json& json) {
  TomlValue value;
  if (json.is_string()) {
    value.data = json.get<std::string>();
  } else if (json.is_boolean()) {
    value.data = json.get<bool>();
  } else if (json.is_number_integer()) {
    value.data = json.get<std::int64_t>();
  } else {
    value.data = json.get<double>();
  }
  return value;
}

Json parameters_json(const SweptRun& run) {
  Json json = Json::object();
  for (const auto& [field, value] : run.parameters)
    json[field] = json_of(value);
  return json;
}

}  // namespace

SweptRuns swept_runs(const SweepFile& sweep) {
  SweptRuns made;
  of_file(sweep.file, [&] { made.runs = sweep.design.kind == DesignKind::grid ? grid(sweep) : sampled(sweep); });
  const std::size_t points = made.runs.size();
  std::erase_if(made.runs, [&](const SweptRun& run) { return broken_constraint(run, sweep).has_value(); });
  if (made.runs.empty())
    throw InputError{fmt::format("{}:{}: constraint: none of the {} runs satisfies all; remove one, or give other axes",
                                 sweep.file, sweep.constraints.front().line, points)};
  made.left_out = points - made.runs.size();
  of_file(sweep.file, [&] { set_ids(made.runs); });
  return made;
}

std::optional<std::size_t> broken_constraint(const SweptRun& run, const SweepFile& sweep) {
  for (std::size_t i = 0; i < sweep.constraints.size(); ++i) {
    try {
      if (!satisfies(run, sweep.constraints[i])) return i;
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}: {}", sweep.constraint_location(i), error.what())};
    }
  }
  return {};
}

TomlValue with_parameters(TomlValue base, const SweptRun& run) {
  for (const auto& [field, value] : run.parameters)
    set_field(base, field, value);
  return base;
}

void check_fields(TomlValue base, const SweptRun& run) {
  // As texts: scripts also give arrays and tables, which no path names.
  for (const auto& [field, value] : run.parameters)
    set_field(base, field, TomlValue{std::string{}});
  std::map<const TomlValue*, std::string> fields;
  for (const auto& [field, value] : run.parameters) {
    const auto [other, is_new] = fields.emplace(&field_at(base, field), field);
    if (!is_new) throw InputError{fmt::format("'{}' and '{}' are the same field; remove one", other->second, field)};
  }
}

void set_ids(std::vector<SweptRun>& runs) {
  std::map<std::string, int> copies;
  std::map<std::string, std::size_t> ids;
  for (std::size_t number = 0; number < runs.size(); ++number) {
    std::string text = parameters_json(runs[number]).dump();
    if (const int copy = copies[text]++; copy > 0) text += fmt::format(" {}", copy);
    runs[number].id = fnv1a(text);
    const auto [other, is_new] = ids.emplace(runs[number].id, number);
    if (!is_new)
      throw InputError{fmt::format("runs {} and {} have the same id; change one of their values slightly",
                                   other->second + 1, number + 1)};
  }
}

std::string id_of(const SweptRun& run) { return fnv1a(parameters_json(run).dump()); }

std::string manifest_line(const SweptRun& run) {
  return Json{{"id", run.id}, {"parameters", parameters_json(run)}}.dump();
}

SweptRun run_of_line(const std::string& line) {
  const auto refused = [](std::string_view reason) {
    return InputError{fmt::format("not a run; remove this line and plan the sweep again: {}", reason)};
  };
  try {
    const Json json = Json::parse(line);
    const records::Node node{json, "run"};
    SweptRun run{node.at("id").text(), {}};
    for (const auto& [field, value] : node.at("parameters").members())
      run.parameters.emplace_back(field, value_of(value.json()));
    return run;
  } catch (const records::RecordError& error) {
    throw refused(error.what());
  } catch (const Json::exception& error) {
    throw refused(records::json_fault(error));
  }
}

}  // namespace talus::app
