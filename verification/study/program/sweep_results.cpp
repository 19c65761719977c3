#include "verification/study/program/sweep_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "verification/study/program/table_units.hpp"

namespace talus::verification::problems {
namespace {

using records::Json;

/// The parameters of a run, which follow its number and id: "field [unit]" over 2.5 is "2.5 unit" in JSON, where the
/// number is as in the sweep, such as 25e-1; numbers without a unit are numbers there, too. Returns the number of these
/// columns.
std::size_t compare_parameters(const records::Csv& csv, std::size_t row, const Json& run, Differences& differ) {
  const Json& parameters = run.at("parameters");
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const TableHead head{csv.header().at(2 + i)};
    const std::string cell{csv.cell(row, 2 + i)};
    differ.holds("a parameter in results.json: " + head.name, parameters.contains(head.name));
    if (!parameters.contains(head.name)) continue;
    const Json& value = parameters.at(head.name);
    std::string text = value.is_string() ? value.get<std::string>() : fmt::format("{}", value.get<double>());
    if (!head.unit.empty() && text.ends_with(" " + head.unit))
      text = fmt::format("{}", std::strtod(text.c_str(), nullptr));
    differ.compare(head.name + " in results.json", text, cell);
  }
  return parameters.size();
}

/// Outputs of a run, the last columns.
void compare_outputs(const records::Csv& csv, std::size_t row, const Json& outputs, const Json& values,
                     Differences& differ) {
  const bool has_values = !values.empty();  // a run without a result has none
  differ.compare("number of values in results.json", has_values ? values.size() : outputs.size(), outputs.size());
  const std::size_t first = csv.header().size() - outputs.size();
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const TableHead head{csv.header()[first + i]};
    const auto output = outputs.at(i).get<std::string>();
    differ.holds("head of " + output, head.name == output || head.name == output + ".result");
    const bool has_cell = !csv.cell(row, first + i).empty(), has_value = has_values && !values.at(i).is_null();
    differ.compare("a value in results.json of " + output, has_value, has_cell);
    if (!has_cell || !has_value) continue;
    const double value = values.at(i).get<double>(), of_cell = csv.number(row, first + i) * size_of_unit(head.unit);
    // Two products with a rounded unit.
    differ.holds(output + " in results.json", std::abs(of_cell - value) <= 1e-15 * std::abs(value));
  }
}

}  // namespace

void compare_sweep(const records::Csv& csv, const Json& json, Differences& differ) {
  const Json &runs = json.at("runs"), &counts = json.at("counts"), &outputs = json.at("outputs");
  differ.compare("units of results.json", json.at("units").get<std::string>(), std::string{"SI"});
  differ.compare("rows of results.json", runs.size(), csv.rows());
  std::map<std::string, std::size_t> ends;
  for (std::size_t row = 0; row < std::min(runs.size(), csv.rows()); ++row) {
    const Json& run = runs.at(row);
    for (const std::string member : {"id", "end", "reason", "verdict"})
      if (member != "verdict" || run.contains(member))
        differ.compare(member + " in results.json", run.at(member).get<std::string>(),
                       std::string{csv.cell(row, member)});
    for (const auto& [member, head] :
         {std::pair{"number", "number"}, {"time", "time [s]"}, {"evaluations", "evaluations"}})
      differ.compare(fmt::format("{} in results.json", member), run.at(member).get<double>(), csv.number(row, head));
    const std::size_t parameters = compare_parameters(csv, row, run, differ);
    differ.compare("columns of results.csv", csv.header().size(),
                   6 + parameters + (run.contains("verdict") ? 1 : 0) + outputs.size());
    compare_outputs(csv, row, outputs, run.at("values"), differ);
    ++ends[std::string{csv.cell(row, "end")}];
  }
  differ.compare("number of runs in results.json", counts.at("runs").get<std::size_t>(), csv.rows());
  differ.compare("number of missing runs", counts.at("missing").get<int>(), 0);
  for (const char* const end : {"finished", "unusable", "diverged", "refused", "limited"})
    differ.compare(fmt::format("number of {} runs", end), counts.at(end).get<std::size_t>(), ends[end]);
}

records::Csv compared_sweep(const Program& program, const std::string& folder, Differences& differ) {
  records::Csv csv = program.csv(folder + "/results.csv");
  compare_sweep(csv, program.file(folder + "/results.json"), differ);
  return csv;
}

}  // namespace talus::verification::problems
