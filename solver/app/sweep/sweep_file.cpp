#include "solver/app/sweep/sweep_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "solver/base/error.hpp"
#include "solver/io/file/quantity_table.hpp"
#include "solver/io/file/toml_field.hpp"
#include "solver/io/scene/scene_table.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/error.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t maximum_runs = 1'000'000;
/// 2^53: above, not all whole numbers are doubles.
constexpr double largest_whole = 9007199254740992.0;

bool is_whole(const TomlValue& value) { return std::holds_alternative<std::int64_t>(value.data); }

bool is_value(const TomlValue& value) {
  return std::holds_alternative<std::string>(value.data) || std::holds_alternative<double>(value.data) ||
         is_whole(value) || std::holds_alternative<bool>(value.data);
}

/// The elements of an array. Errors: of another value.
const TomlArray& array_of(const SceneTable& table, std::string_view key, const TomlValue& value, std::size_t minimum,
                          std::string_view what) {
  const TomlArray* const array = std::get_if<TomlArray>(&value.data);
  if (array == nullptr || array->size() < minimum)
    table.fail(key, fmt::format("found {}; it must be an array of {}", found(value), what));
  return *array;
}

/// The number of a value, in the unit that all values of the key must have.
double in_unit(const SceneTable& table, std::string_view key, const TomlValue& value,
               std::optional<std::string>& unit) {
  WrittenNumber number;
  try {
    number = written_number(value);
  } catch (const InputError& error) {
    table.fail(key, error.what());
  }
  if (unit && *unit != number.unit) {
    table.fail(key, fmt::format("found {} and a value in {}; give all in one unit", found(value),
                                unit->empty() ? "no unit" : *unit));
  }
  unit = number.unit;
  return number.value;
}

Continuous read_range(SceneTable& table, const TomlValue& value) {
  const TomlArray& ends = array_of(table, "range", value, 2, "two values, the first and the last");
  if (ends.size() != 2) table.fail("range", fmt::format("found {}; it must be an array of two values", found(value)));
  Continuous made;
  std::optional<std::string> unit;
  const double first = in_unit(table, "range", ends[0], unit), last = in_unit(table, "range", ends[1], unit);
  if (!(first < last))
    table.fail("range", fmt::format("found {}; the first value must be less than the second", found(value)));
  made.unit = *unit, made.is_range = true, made.whole = is_whole(ends[0]) && is_whole(ends[1]);
  made.quantiles = {{0.0, first}, {1.0, last}};
  if (made.whole && !(std::abs(first) <= largest_whole && std::abs(last) <= largest_whole))
    table.fail("range", fmt::format("found {}; whole numbers must be at most 2^53", found(value)));
  return made;
}

Continuous read_quantiles(SceneTable& table, const TomlValue& value) {
  constexpr std::string_view what = "pairs [probability, value], the first probability 0 and the last one 1";
  Continuous made;
  std::optional<std::string> unit;
  for (const TomlValue& pair : array_of(table, "quantiles", value, 2, what)) {
    const TomlArray* const both = std::get_if<TomlArray>(&pair.data);
    if (both == nullptr || both->size() != 2)
      table.fail("quantiles", fmt::format("found {}; it must be an array of {}", found(pair), what));
    std::optional<std::string> none{""};
    const double probability = in_unit(table, "quantiles", (*both)[0], none);
    made.quantiles.emplace_back(probability, in_unit(table, "quantiles", (*both)[1], unit));
  }
  made.unit = *unit;
  const auto& all = made.quantiles;
  if (all.front().first != 0.0 || all.back().first != 1.0)
    table.fail("quantiles", fmt::format("found probabilities from {} to {}; they must be from 0 to 1",
                                        all.front().first, all.back().first));
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (!(all[i].first > all[i - 1].first && all[i].second >= all[i - 1].second))
      table.fail("quantiles", fmt::format("found [{}, {}] after [{}, {}]; probabilities and values must grow",
                                          all[i].first, all[i].second, all[i - 1].first, all[i - 1].second));
  }
  return made;
}

/// Whether a column without a unit is of texts, or of true and false: none of its cells begins a number.
bool is_text_column(const records::Csv& csv, std::size_t column) {
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const std::string_view text = csv.cell(row, column);
    double number = 0.0;
    if (text.empty() || std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc{}) return false;
  }
  return true;
}

/// The number of a cell with the unit of its column; without a unit, whole numbers stay whole.
TomlValue number_of_cell(const records::Csv& csv, std::size_t row, std::size_t column, const std::string& unit) {
  const double number = csv.number(row, column);
  const std::string_view text = csv.cell(row, column);
  std::int64_t whole = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), whole);
  TomlValue value;
  if (!unit.empty()) {
    value.data = fmt::format("{} {}", number, unit);
  } else if (read.ec == std::errc{} && read.ptr == text.data() + text.size()) {
    value.data = whole;
  } else {
    value.data = number;
  }
  return value;
}

/// The columns of a CSV file that give fields, as axis of rows.
SweepAxis read_rows(SceneTable& table, const fs::path& folder) {
  SweepAxis axis;
  axis.line = table.line();
  const fs::path file = folder / table.file_name("table");
  const TomlValue* const written = table.value("columns");
  const TomlTable* const fields = written == nullptr ? nullptr : std::get_if<TomlTable>(&written->data);
  if (fields == nullptr || fields->empty())
    table.fail("columns", "it must be a table of fields with their headings, e.g. { \"run.step\" = \"step [s]\" }");
  SceneTable columns = table.table("columns");
  try {
    const records::Csv csv = records::read_csv(file);
    axis.rows.resize(csv.rows());
    for (const TomlEntry& entry : *fields) {
      const std::string heading = columns.text(entry.key);
      if (std::ranges::find(csv.header(), heading) == csv.header().end())
        columns.fail(entry.key,
                     fmt::format("{}: {}", file.string(), unknown_name("column", heading, csv.header()).what()));
      const std::string unit = name_and_unit(heading).second;
      const std::size_t column = csv.column(heading);
      axis.fields.push_back(entry.key);
      try {
        static_cast<void>(parse_any_quantity("1 " + unit, si));
      } catch (const InputError& error) {
        columns.fail(entry.key, error.what());
      }
      const bool is_text = unit.empty() && is_text_column(csv, column);
      for (std::size_t row = 0; row < csv.rows(); ++row) {
        const std::string text{csv.cell(row, column)};
        axis.rows[row].push_back(!is_text                            ? number_of_cell(csv, row, column, unit)
                                 : text == "true" || text == "false" ? TomlValue{text == "true"}
                                                                     : TomlValue{text});
      }
    }
  } catch (const records::FileError& error) {
    throw IoError{fmt::format("{}:{}: axis: table: {}", table.source().file, table.line(), error.what())};
  } catch (const records::RecordError& error) {
    throw InputError{error.what()};
  }
  if (axis.rows.empty()) table.fail("table", fmt::format("{}: found no line below the header", file.string()));
  return axis;
}

SweepAxis read_axis(SceneTable& table, const fs::path& folder) {
  table.allow({"field", "values", "range", "count", "spacing", "quantiles", "table", "columns"});
  if (table.has("table")) {
    for (const char* other : {"field", "values", "range", "count", "spacing", "quantiles"})
      table.refuse(other, "the columns of the table give the fields and their values");
    return read_rows(table, folder);
  }
  table.refuse("columns", "it names columns of a table; give `table`, too");
  SweepAxis axis;
  axis.line = table.line();
  axis.fields.push_back(table.text("field"));
  const TomlValue *values = table.value("values"), *range = table.value("range"), *quantiles = table.value("quantiles");
  if ((values != nullptr) + (range != nullptr) + (quantiles != nullptr) != 1)
    table.fail("values", "give one of values, range and quantiles, or a table");
  if (values != nullptr) {
    for (const TomlValue& value : array_of(table, "values", *values, 1, "values, at least one")) {
      if (!is_value(value))
        table.fail("values", fmt::format("found {}; each must be a number, a text, true or false", found(value)));
      if (const auto* number = std::get_if<double>(&value.data); number != nullptr && !std::isfinite(*number))
        table.fail("values", fmt::format("found {}; it must be finite", found(value)));
      axis.rows.push_back({value});
    }
    for (const char* other : {"count", "spacing"})
      table.refuse(other, "the values are given; remove it");
    return axis;
  }
  Continuous& made =
      axis.continuous.emplace(range != nullptr ? read_range(table, *range) : read_quantiles(table, *quantiles));
  made.spacing = table.choice_or("spacing", Spacing::even);
  if (made.spacing == Spacing::logarithmic && !(made.quantiles.front().second > 0.0))
    table.fail("spacing",
               fmt::format("found \"logarithmic\" from {} on; the values must be > 0", made.quantiles.front().second));
  if (made.whole && made.spacing == Spacing::logarithmic)
    table.fail("spacing", "found \"logarithmic\" of whole numbers; write the range with decimals, e.g. 1.0");
  if (table.has("count")) made.count = table.whole_between("count", 2, maximum_runs);
  if (const double numbers = made.quantiles.back().second - made.quantiles.front().second + 1.0;
      made.whole && static_cast<double>(made.count) > numbers)
    table.fail("count", fmt::format("found {}; there are {} whole numbers in the range; give at most as many, or "
                                    "write the range with decimals, e.g. [0.0, 1.0]",
                                    made.count, numbers));
  return axis;
}

SweepConstraint read_constraint(SceneTable& table, const std::set<std::string>& varied) {
  table.allow({"field", "at_most", "at_least", "factor"});
  const auto demand_varied = [&](std::string_view key, const std::string& field) {
    if (!varied.contains(field))
      table.fail(key, unknown_name("field that is varied", field, {varied.begin(), varied.end()}).what());
  };
  SweepConstraint made;
  made.line = table.line();
  made.field = table.text("field");
  demand_varied("field", made.field);
  const TomlValue *upper = table.value("at_most"), *lower = table.value("at_least");
  if ((upper == nullptr) == (lower == nullptr)) table.fail("at_most", "give one of at_most and at_least");
  made.is_upper = upper != nullptr;
  made.value = made.is_upper ? *upper : *lower;
  const std::string_view key = made.is_upper ? "at_most" : "at_least";
  if (const std::string* const text = std::get_if<std::string>(&made.value.data);
      text != nullptr && varied.contains(*text))
    made.other = *text;
  if (made.other.empty()) {
    try {
      static_cast<void>(written_number(made.value));
    } catch (const InputError&) {
      table.fail(key,
                 fmt::format("found {}; it must be a field that is varied, a number or a quantity", found(made.value)));
    }
  }
  if (table.has("factor")) made.factor = table.number("factor", Range::positive);
  return made;
}

void read_design(SceneTable table, SweepFile& sweep) {
  table.allow({"kind", "runs", "seed"});
  const std::size_t errors = table.source().errors();
  sweep.design.kind = table.choice_or("kind", DesignKind::grid);
  if (table.source().errors() > errors) return;
  if (sweep.design.kind == DesignKind::grid) {
    for (const char* other : {"runs", "seed"})
      table.refuse(other, "a grid has every combination of the axes' points; remove it");
    return;
  }
  sweep.design.runs = table.whole_between("runs", 1, maximum_runs);
  if (table.has("seed")) sweep.design.seed = table.whole_between("seed", 0, 1'000'000'000);
}

/// Errors of axes that only all together have.
void check_axes(SceneTable& file, const SweepFile& sweep, std::vector<SceneTable>& tables) {
  std::set<std::string> varied;
  double runs = 1.0;
  for (std::size_t i = 0; i < sweep.axes.size(); ++i) {
    const SweepAxis& axis = sweep.axes[i];
    for (const std::string& field : axis.fields) {
      try {
        static_cast<void>(field_keys(field));
      } catch (const InputError& error) {
        tables[i].fail("field", error.what());
      }
      if (!varied.insert(field).second)
        tables[i].fail("field", fmt::format("'{}' is varied by two axes; remove one", field));
    }
    const bool is_grid = sweep.design.kind == DesignKind::grid;
    if (is_grid && axis.continuous && axis.continuous->count == 0)
      tables[i].fail("count", "it is missing; a grid needs the number of points");
    runs *= axis.continuous ? static_cast<double>(axis.continuous->count) : static_cast<double>(axis.rows.size());
    if (is_grid && runs > maximum_runs)
      file.fail("axis", fmt::format("found a grid of at least {:.3g} runs; it must be at most {}", runs, maximum_runs));
    if (!is_grid && axis.continuous && axis.continuous->count != 0)
      tables[i].fail("count", "only a grid has it; give `runs` of the design");
  }
}

}  // namespace

SweepLimits read_limits(SceneTable table) {
  SweepLimits limits;
  table.allow({"time", "evaluations"});
  if (table.has("time")) limits.time = table.quantity("time", dimension::time, Range::positive);
  if (table.has("evaluations")) limits.evaluations = table.whole_between("evaluations", 1, 1'000'000'000'000);
  return limits;
}

SweepLimits read_evaluation_limit(SceneTable table) {
  table.refuse("time", "results would depend on the machine; give `evaluations`");
  return read_limits(std::move(table));
}

double Continuous::at(double probability) const {
  const auto after = std::ranges::upper_bound(quantiles, probability, {}, &std::pair<double, double>::first);
  const auto& [p1, x1] = after == quantiles.end() ? quantiles.back() : *after;
  const auto& [p0, x0] = after == quantiles.end() ? quantiles[quantiles.size() - 2] : *std::prev(after);
  if (probability >= 1.0) return quantiles.back().second;
  if (whole) return std::min(std::floor(x0 + probability * (x1 - x0 + 1.0)), x1);
  const double fraction = (probability - p0) / (p1 - p0);
  if (spacing == Spacing::even) return std::lerp(x0, x1, fraction);
  const double quotient = x1 / x0;
  if (std::isfinite(quotient)) return x0 * std::pow(quotient, fraction);
  return std::exp(std::lerp(std::log(x0), std::log(x1), fraction));
}

TomlValue Continuous::written(double probability) const {
  const double value = at(probability);
  TomlValue made;
  if (whole) {
    made.data = static_cast<std::int64_t>(value);
  } else if (unit.empty()) {
    made.data = value;
  } else {
    made.data = fmt::format("{} {}", value, unit);
  }
  return made;
}

TomlValue value_in(double number, const std::string& unit) {
  if (!unit.empty()) return TomlValue{fmt::format("{} {}", number, unit)};
  if (number == std::floor(number) && std::abs(number) <= largest_whole)
    return TomlValue{static_cast<std::int64_t>(number)};
  return TomlValue{number};
}

WrittenNumber written_number(const TomlValue& value) {
  if (const auto* number = std::get_if<double>(&value.data)) {
    if (!std::isfinite(*number)) throw InputError{fmt::format("found {}; it must be finite", found(value))};
    return {*number, ""};
  }
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return {static_cast<double>(*whole), ""};
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) throw InputError{fmt::format("found {}; it must be a number or a quantity", found(value))};
  static_cast<void>(parse_any_quantity(*text, si));
  constexpr std::string_view blanks = " \t";
  std::string_view rest{*text};
  rest.remove_prefix(rest.find_first_not_of(blanks));
  if (rest.front() == '+') rest.remove_prefix(1);
  WrittenNumber made;
  const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), made.value);
  TALUS_DEMAND(read.ec == std::errc{});  // it is a quantity
  rest.remove_prefix(static_cast<std::size_t>(read.ptr - rest.data()));
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  made.unit = rest.substr(0, rest.find_last_not_of(blanks) + 1);
  return made;
}

std::string SweepFile::axis_location(std::size_t axis) const {
  return fmt::format("{}:{}: axis {}", file, axes[axis].line, axis + 1);
}

std::string SweepFile::constraint_location(std::size_t constraint) const {
  return fmt::format("{}:{}: constraint {}", file, constraints[constraint].line, constraint + 1);
}

std::string SweepFile::outputs_location() const { return fmt::format("{}:{}: outputs", file, outputs_line); }

std::string SweepFile::base_location() const { return fmt::format("{}:{}: base", file, base_line); }

SweepFile read_sweep(std::string_view text, const fs::path& name) {
  const TomlValue document = parse_toml(text, name.string());
  SceneSource source{name.string(), si};
  SceneTable file{source, document, ""};
  const fs::path folder = name.parent_path();
  SweepFile sweep;
  source.collect();
  try {
    file.allow({"title", "base", "outputs", "axis", "design", "constraint", "limits"});
    sweep.file = name.string();
    sweep.title = file.title();
    sweep.base = folder / file.file_name("base");
    if (const TomlValue* const base = file.value("base")) sweep.base_line = base->line;
    const TomlValue* const outputs = file.value("outputs");
    if (outputs != nullptr) sweep.outputs_line = outputs->line;
    if (outputs == nullptr) file.fail("outputs", "it is missing; give quantities, e.g. [\"rock.vx.end\"]");
    for (const TomlValue& output : array_of(file, "outputs", *outputs, 1, "texts, e.g. [\"rock.vx.end\"]")) {
      const auto* quantity = std::get_if<std::string>(&output.data);
      if (quantity == nullptr) file.fail("outputs", fmt::format("found {}; it must be a text", found(output)));
      if (std::ranges::find(sweep.outputs, *quantity) != sweep.outputs.end())
        file.fail("outputs", fmt::format("found {} twice; remove one", found(output)));
      sweep.outputs.push_back(*quantity);
    }
    if (file.has("design")) read_design(file.table("design"), sweep);
    std::vector<SceneTable> axes = file.numbered_tables("axis");
    if (!file.has("axis")) file.fail("axis", "it is missing; give at least one [[axis]]");
    for (SceneTable& table : axes)
      sweep.axes.push_back(read_axis(table, folder));
    // Of other errors they could be the consequence.
    if (source.errors() == 0) check_axes(file, sweep, axes);
    std::set<std::string> varied;
    for (const SweepAxis& axis : sweep.axes)
      varied.insert(axis.fields.begin(), axis.fields.end());
    for (SceneTable& table : file.numbered_tables("constraint"))
      sweep.constraints.push_back(read_constraint(table, varied));
    if (file.has("limits")) sweep.limits = read_limits(file.table("limits"));
  } catch (const SceneSource::Collected&) {
    source.check();
    throw;
  }
  source.check();
  return sweep;
}

}  // namespace talus::app
