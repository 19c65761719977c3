#include "solver/app/fit/fit_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/base/error.hpp"
#include "solver/io/scene/scene_table.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/error.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// The unit in brackets at the end of a heading; empty if there is none.
std::string unit_of(const std::string& heading) {
  const std::size_t open = heading.rfind('[');
  if (open == std::string::npos || !heading.ends_with(']')) return {};
  return heading.substr(open + 1, heading.size() - open - 2);
}

/// The numbers of a column. Errors: InputError for a heading that the data do not have.
std::vector<double> column(SceneTable& table, const records::Csv& data, std::string_view key,
                           const std::string& heading) {
  if (std::ranges::find(data.header(), heading) == data.header().end()) {
    table.fail(key, fmt::format("found \"{}\"; it must be a column of {}: \"{}\"", heading, data.file().string(),
                                fmt::join(data.header(), "\", \"")));
  }
  if (std::ranges::count(data.header(), heading) > 1)
    table.fail(key, fmt::format("found \"{}\", which {} has twice; give columns different headings", heading,
                                data.file().string()));
  std::vector<double> values;
  const std::size_t at = data.column(heading);
  for (std::size_t row = 0; row < data.rows(); ++row)
    values.push_back(data.number(row, at));
  return values;
}

/// A number, in quotes with its unit.
WrittenNumber number_of(SceneTable& table, std::string_view key, const TomlValue& value) {
  try {
    return written_number(value);
  } catch (const InputError& error) {
    table.fail(key, error.what());
  }
}

/// "f.toml:7: input 1", for errors that are found later.
std::string where(const SceneTable& table, const char* kind, std::size_t number) {
  return fmt::format("{}:{}: {} {}", table.source().file, table.line(), kind, number);
}

FitInput read_input(SceneTable& table, const records::Csv& data) {
  table.allow({"column", "field"});
  FitInput input;
  input.heading = table.text("column");
  input.field = table.text("field");
  input.unit = unit_of(input.heading);
  input.values = column(table, data, "column", input.heading);
  return input;
}

FitQuantity read_quantity(SceneTable& table, const records::Csv& data) {
  table.allow({"name", "column", "result", "divided_by", "uncertainty"});
  FitQuantity quantity;
  quantity.heading = table.text("column");
  quantity.name = table.has("name") ? table.text("name") : quantity.heading.substr(0, quantity.heading.find(" ["));
  quantity.unit = unit_of(quantity.heading);
  quantity.result = table.text("result");
  if (table.has("divided_by")) {
    const std::string heading = table.text("divided_by");
    quantity.divisor_unit = unit_of(heading);
    quantity.divisors = column(table, data, "divided_by", heading);
    if (std::ranges::find(quantity.divisors, 0.0) != quantity.divisors.end())
      table.fail(
          "divided_by",
          fmt::format("found 0 in \"{}\"; results cannot be divided by it; remove the line of the data", heading));
  }
  if (const TomlValue* const uncertainty = table.value("uncertainty")) {
    const WrittenNumber written = number_of(table, "uncertainty", *uncertainty);
    if (written.unit != quantity.unit || !(written.value > 0.0)) {
      table.fail("uncertainty",
                 fmt::format("found {}; it must be > 0, {}", found(*uncertainty),
                             quantity.unit.empty() ? "a pure number as the column"
                                                   : fmt::format("in the unit of the column, {}", quantity.unit)));
    }
    quantity.uncertainty = written.value;
  }
  quantity.values = column(table, data, "column", quantity.heading);
  return quantity;
}

FittedField read_parameter(SceneTable& table) {
  table.allow({"field", "range", "start", "spacing"});
  FittedField fitted;
  fitted.field = table.text("field");
  const TomlValue* const range = table.value("range");
  const auto* const ends = range == nullptr ? nullptr : std::get_if<TomlArray>(&range->data);
  if (ends == nullptr || ends->size() != 2)
    table.fail("range", "it must be two bounds, e.g. [\"1 N s/m\", \"100 N s/m\"] or [0.0, 1.0]");
  const WrittenNumber lower = number_of(table, "range", (*ends)[0]), upper = number_of(table, "range", (*ends)[1]);
  FitParameter& parameter = fitted.parameter;
  parameter.lower = lower.value, parameter.upper = upper.value, fitted.unit = lower.unit;
  if (lower.unit != upper.unit)
    table.fail("range", fmt::format("found {}; both ends must have the same unit", found(*range)));
  if (!(lower.value < upper.value))
    table.fail("range", fmt::format("found {}; the first must be less than the second", found(*range)));
  parameter.spacing = table.choice_or("spacing", Spacing::even);
  const bool is_logarithmic = parameter.spacing == Spacing::logarithmic;
  if (is_logarithmic && !(lower.value > 0.0))
    table.fail("range", fmt::format("found {}; with spacing = \"logarithmic\" both ends must be > 0", found(*range)));
  parameter.start = is_logarithmic ? std::sqrt(lower.value * upper.value) : std::midpoint(lower.value, upper.value);
  if (const TomlValue* const start = table.value("start")) {
    const WrittenNumber written = number_of(table, "start", *start);
    if (written.unit != fitted.unit || !(written.value >= lower.value && written.value <= upper.value))
      table.fail("start", fmt::format("found {}; it must be within {}, in its unit", found(*start), found(*range)));
    parameter.start = written.value, fitted.has_start = true;
  }
  return fitted;
}

/// The errors that no table has alone.
void check(SceneTable& file, const FitFile& made) {
  for (const char* const key : {"quantity", "parameter"}) {
    const TomlValue* const value = file.value(key);
    const auto* const list = value == nullptr ? nullptr : std::get_if<TomlArray>(&value->data);
    if (value == nullptr || (list != nullptr && list->empty()))
      file.report(key, fmt::format("it is missing; give at least one [[{}]]", key));
  }
  if (const std::size_t values = made.rows * made.quantities.size(); values > 0 && values <= made.parameters.size()) {
    file.report("parameter", fmt::format("found {} for {} measured values; there must be more values than parameters",
                                         made.parameters.size(), values));
  }
  for (auto first = made.quantities.begin(); first != made.quantities.end(); ++first) {
    if (std::ranges::any_of(made.quantities.begin(), first,
                            [&](const FitQuantity& earlier) { return earlier.name == first->name; }))
      file.report("quantity", fmt::format("found two called \"{}\"; give them different names", first->name));
  }
  constexpr std::size_t maximum = 8;
  if (made.parameters.size() > maximum)
    file.report("parameter", fmt::format("found {}; there may be at most {}", made.parameters.size(), maximum));
  const auto given =
      std::ranges::count_if(made.quantities, [](const FitQuantity& of) { return of.uncertainty.has_value(); });
  if (given != 0 && static_cast<std::size_t>(given) != made.quantities.size())
    file.report("quantity", "some have an uncertainty, others not; give all of them, or none");
  if (given == 0 && made.quantities.size() > 1)
    file.report("quantity",
                "several quantities need an uncertainty each, by which their deviations are compared; give them");
}

}  // namespace

FitFile read_fit(std::string_view text, const fs::path& name) {
  const TomlValue document = parse_toml(text, name.string());
  SceneSource source{name.string(), si};
  SceneTable file{source, document, ""};
  const fs::path folder = name.parent_path();
  FitFile made;
  made.file = name;
  source.collect();
  try {
    file.allow({"title", "scene", "data", "input", "quantity", "parameter", "bootstrap", "limits"});
    made.title = file.title();
    made.scene = folder / file.file_name("scene");
    made.data = folder / file.file_name("data");
    const records::Csv data = records::read_csv(made.data);
    made.rows = data.rows();
    if (made.rows == 0)
      file.fail("data", fmt::format("{}: found no line below the header; there must be one for each experiment",
                                    made.data.string()));
    const auto read_all = [&](const char* kind, auto& list, auto&& read) {
      std::size_t number = 0;
      for (SceneTable& table : file.numbered_tables(kind)) {
        ++number;
        table.guard([&] {
          list.push_back(read(table));
          list.back().where = where(table, kind, number);
        });
      }
    };
    read_all("input", made.inputs, [&](SceneTable& table) { return read_input(table, data); });
    read_all("quantity", made.quantities, [&](SceneTable& table) { return read_quantity(table, data); });
    read_all("parameter", made.parameters, read_parameter);
    check(file, made);
    if (file.has("bootstrap")) {
      SceneTable bootstrap = file.table("bootstrap");
      bootstrap.allow({"samples", "seed"});
      if (bootstrap.has("samples"))
        made.samples = static_cast<std::size_t>(bootstrap.whole_between("samples", 0, 100'000));
      constexpr std::size_t fewest = 40;
      if (made.samples > 0 && made.samples < fewest)
        bootstrap.report("samples", fmt::format("found {}; it must be 0, or at least {}", made.samples, fewest));
      if (bootstrap.has("seed")) made.seed = bootstrap.whole_between("seed", 0, 1'000'000'000);
    }
    if (file.has("limits")) made.limits = read_evaluation_limit(file.table("limits"));
  } catch (const SceneSource::Collected&) {
    source.check();
    throw;
  } catch (const records::FileError& error) {
    source.check();
    throw IoError{fmt::format("{}: data: {}", name.string(), error.what())};
  } catch (const records::RecordError& error) {
    source.check();
    throw InputError{fmt::format("{}: data: {}", name.string(), error.what())};
  }
  source.check();
  return made;
}

}  // namespace talus::app
