#include "solver/app/sweep/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "solver/base/error.hpp"
#include "verification/record/csv.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

/// A column of a field that is varied; with numbers in one unit, or with texts.
struct ParameterColumn {
  std::string name;
  bool has_numbers{true};
  std::string unit;
};

std::vector<ParameterColumn> parameter_columns(const SweepFolder& sweep) {
  std::vector<ParameterColumn> columns;
  for (std::size_t i = 0; i < sweep.runs.front().parameters.size(); ++i) {
    ParameterColumn column{.name = sweep.runs.front().parameters[i].first, .unit = {}};
    std::optional<std::string> unit;
    for (const SweptRun& run : sweep.runs) {
      try {
        const WrittenNumber number = written_number(run.parameters[i].second);
        if (unit && *unit != number.unit) column.has_numbers = false;
        unit = number.unit;
      } catch (const InputError&) {
        column.has_numbers = false;
      }
      if (!column.has_numbers) break;
    }
    if (column.has_numbers) column.unit = *unit;
    columns.push_back(column);
  }
  return columns;
}

std::string head(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string text_of(const TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.data)) return *text;
  return found(value);
}

/// Calls visit(number from 1, run, result) for each run with a result.
template <class Visit>
void for_each_result(const SweepFolder& sweep, const KnownResults& known, Visit&& visit) {
  for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
    const auto result = known.by_id.find(sweep.runs[i].id);
    if (result != known.by_id.end()) visit(i + 1, sweep.runs[i], result->second);
  }
}

}  // namespace

std::string SweepCounts::text(std::string_view what) const {
  std::string text = fmt::format("{} of {} runs{}: {} finished", done(), runs, what, finished());
  for (std::size_t end = 0; end < ends.size(); ++end)
    if (static_cast<SweepEnd>(end) != SweepEnd::finished && ends[end] > 0)
      text += fmt::format(", {} {}", ends[end], Names<SweepEnd>::list[end]);
  return text;
}

Json SweepCounts::json() const {
  Json json{{"runs", runs}, {"missing", missing()}};
  for (std::size_t end = 0; end < ends.size(); ++end)
    json[std::string{Names<SweepEnd>::list[end]}] = ends[end];
  return json;
}

SweepCounts counts_of(const SweepFolder& sweep, const KnownResults& known) {
  SweepCounts counts{.runs = sweep.runs.size()};
  for (const auto& [id, result] : known.by_id)
    ++counts.ends[static_cast<std::size_t>(result.end)];
  return counts;
}

std::string sweep_csv(const SweepFolder& sweep, const KnownResults& known, const SweepBase& base) {
  const std::vector<ParameterColumn> parameters = parameter_columns(sweep);
  std::vector<std::string> heads{"number", "id"};
  for (const ParameterColumn& column : parameters)
    heads.push_back(head(column.name, column.unit));
  heads.insert(heads.end(), {"end", "reason", "time [s]", "evaluations"});
  if (base.is_fence()) heads.emplace_back("verdict");
  for (const SweepOutput& output : base.outputs()) {
    // A cell's restitution is a field and a result.
    const bool is_field = std::ranges::find(parameters, output.name, &ParameterColumn::name) != parameters.end();
    heads.push_back(head(is_field ? output.name + ".result" : output.name,
                         output.dimension == dimension::number ? "" : symbol(base.units(), output.dimension)));
  }
  records::CsvText csv{heads};
  for_each_result(sweep, known, [&](std::size_t number, const SweptRun& run, const SweepResult& result) {
    csv.cell(fmt::format("{}", number));
    csv.cell(run.id);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const TomlValue& value = run.parameters[i].second;
      if (parameters[i].has_numbers) {
        csv.number(written_number(value).value);
      } else {
        csv.cell(text_of(value));
      }
    }
    csv.cell(name_of(result.end));
    csv.cell(result.reason);
    csv.number(result.time);
    csv.cell(fmt::format("{}", result.evaluations));
    if (base.is_fence()) csv.cell(result.verdict);
    for (std::size_t i = 0; i < sweep.outputs.size(); ++i) {
      if (i < result.values.size() && std::isfinite(result.values[i])) {
        csv.number(result.values[i]);
      } else {
        csv.cell("");
      }
    }
    csv.end_row();
  });
  return std::move(csv).text();
}

std::string sweep_json(const SweepFolder& sweep, const KnownResults& known, const SweepBase& base) {
  Json json{{"schema", 1}, {"title", sweep.title}, {"units", "SI"}, {"outputs", sweep.outputs}};
  json["counts"] = counts_of(sweep, known).json();
  json["runs"] = Json::array();
  for_each_result(sweep, known, [&](std::size_t number, const SweptRun& run, const SweepResult& result) {
    Json row{{"number", number}};
    row.update(Json::parse(manifest_line(run)));
    row["end"] = name_of(result.end);
    row["reason"] = result.reason;
    row["time"] = result.time;
    row["evaluations"] = result.evaluations;
    if (base.is_fence()) row["verdict"] = result.verdict;
    Json values = Json::array();
    for (std::size_t i = 0; i < result.values.size(); ++i)
      values.push_back(result.values[i] * si_size(base.units(), base.outputs()[i].dimension));
    row["values"] = std::move(values);
    json["runs"].push_back(std::move(row));
  });
  return json.dump(1) + "\n";
}

}  // namespace talus::app
