#include "verification/data/run_results.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.hpp"
#include "solver/io/file/quantity_table.hpp"
#include "verification/record/json_node.hpp"

namespace talus::verification {

namespace {

std::vector<std::string> names_of(const records::Csv& file) {
  std::vector<std::string> names;
  for (const std::string& heading : file.header())
    names.push_back(name_and_unit(heading).first);
  return names;
}

/// Index of a column by its name without unit.
std::size_t column_of(const records::Csv& file, const std::string& name) {
  const std::vector<std::string> names = names_of(file);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw unknown_name(fmt::format("column of {}", file.file().filename().string()), name, names);
  return static_cast<std::size_t>(found - names.begin());
}

/// Removes the text up to the first dot, and returns it.
std::string taken_word(std::string& name) {
  const std::size_t dot = std::min(name.find('.'), name.size());
  const std::string word = name.substr(0, dot);
  name.erase(0, dot + 1);
  return word;
}

}  // namespace

std::string unit_of_heading(std::string_view heading) {
  const std::string unit = name_and_unit(heading).second;
  return unit.empty() ? "1" : unit;
}

RunResults::RunResults(const std::filesystem::path& folder)
    : history_{records::read_csv(folder / "history.csv")}, impacts_{records::read_csv(folder / "impacts.csv")} {
  const std::filesystem::path file = folder / "summary.json";
  const records::Json json = records::read_json(file);
  const records::Node summary{json, file.string()};
  for (const records::Node& each : summary.at("extremes").list()) {
    extremes_.push_back({each.at("name").text(), each.at("unit").text(), each.at("minimum").finite(),
                         each.at("maximum").finite(), each.at("minimum_time").finite(),
                         each.at("maximum_time").finite()});
  }
  unit_of_time_ = summary.at("units").at("time").text();
  step_ = summary.at("step").finite();
}

RunResult RunResults::of_history(std::size_t row, const std::string& name) const {
  const std::size_t column = column_of(history_, name);
  return {history_.number(row, column), unit_of_heading(history_.header()[column])};
}

RunResult RunResults::of_extremes(const std::string& which, const std::string& name) const {
  std::vector<std::string> names;
  for (const Extreme& each : extremes_) {
    names.push_back(each.name);
    if (each.name != name) continue;
    if (which == "minimum") return {each.minimum, each.unit};
    if (which == "maximum") return {each.maximum, each.unit};
    return {which == "minimum_time" ? each.minimum_time : each.maximum_time, unit_of_time_};
  }
  throw unknown_name("extreme", name, names);
}

RunResult RunResults::of_impacts(const std::string& name) const {
  std::string rest = name;
  const std::string number = taken_word(rest);
  const std::size_t dot = std::min(rest.rfind('.'), rest.size());
  const std::string contact = rest.substr(0, dot), which = dot < rest.size() ? rest.substr(dot + 1) : "";
  const std::size_t column = column_of(impacts_, which), contacts = column_of(impacts_, "contact");
  std::size_t count = 0;
  for (std::size_t row = 0; row < impacts_.rows(); ++row) {
    if (impacts_.cell(row, contacts) != contact) continue;
    if (fmt::format("{}", ++count) == number)
      return {impacts_.number(row, column), unit_of_heading(impacts_.header()[column])};
  }
  throw InputError{fmt::format("found impact '{}' of '{}'; give one of the {} impacts of this contact in the run",
                               number, contact, count)};
}

RunResult RunResults::single(const std::string& name) const {
  std::string rest = name;
  const std::string which = taken_word(rest);
  if (which == "initial") return of_history(0, rest);
  if (which == "final") return of_history(history_.rows() - 1, rest);
  if (which == "impact") return of_impacts(rest);
  const std::vector<std::string> extremes{"minimum", "maximum", "minimum_time", "maximum_time"};
  if (std::find(extremes.begin(), extremes.end(), which) != extremes.end()) return of_extremes(which, rest);
  throw unknown_name("result", which,
                     {"initial", "final", "minimum", "maximum", "minimum_time", "maximum_time", "impact"});
}

RunResult RunResults::at(const std::string& name) const {
  const std::string divided = " / ";
  const std::size_t at = name.find(divided);
  if (at == std::string::npos) return single(name);
  const RunResult above = single(name.substr(0, at)), below = single(name.substr(at + divided.size()));
  return {above.value / below.value, above.unit == below.unit ? "1" : fmt::format("{} / {}", above.unit, below.unit)};
}

}  // namespace talus::verification
