#include "solver/io/file/quantity_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <tuple>

#include "solver/base/error.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/error.hpp"

namespace talus {
namespace {

std::vector<std::string> column_names(const std::vector<AllowedColumn>& columns) {
  std::vector<std::string> names;
  for (const AllowedColumn& column : columns)
    names.push_back(column.name);
  return names;
}

/// The allowed column that a head names. Errors: InputError without the file.
const AllowedColumn& column_of(const std::string& name, const std::vector<AllowedColumn>& allowed) {
  const auto found = std::ranges::find(allowed, name, &AllowedColumn::name);
  if (found == allowed.end()) throw unknown_name("column", name, column_names(allowed));
  return *found;
}

/// A number of a cell in consistent units. Errors: InputError without the file.
double value_of(double number, const std::string& unit, const AllowedColumn& column, const UnitSystem& units) {
  return unit.empty() ? number : consistent(number, unit, column.dimension, units);
}

/// The unit of a column, empty for a pure number. Errors: InputError without the file.
std::string unit_of(const std::string& unit, const AllowedColumn& column, const UnitSystem& units) {
  const bool is_number = column.dimension == dimension::number;
  if (is_number && (unit.empty() || unit == "1")) return "";
  if (is_number) throw InputError{fmt::format("found the unit {}; it must be a pure number, without a unit", unit)};
  if (unit.empty()) {
    throw InputError{fmt::format("found no unit; it must be {}, e.g. {} [{}]", text_of(column.dimension), column.name,
                                 symbol(si, column.dimension))};
  }
  static_cast<void>(parse_quantity("1 " + unit, column.dimension, units));
  return unit;
}

QuantityColumn read_column(const records::Csv& csv, std::size_t column_index, const std::vector<AllowedColumn>& allowed,
                           const UnitSystem& units) {
  const std::string file = csv.file().string(), head = csv.header()[column_index];
  const auto is_control = [](char letter) { return static_cast<unsigned char>(letter) < 0x20; };
  if (const auto found = std::ranges::find_if(head, is_control); found != head.end()) {
    throw InputError{
        fmt::format("{}: column {}: found a line end or a control character in its heading, after '{}'; "
                    "remove it",
                    file, column_index + 1, std::string{head.begin(), found})};
  }
  std::string name, unit;
  std::tie(name, unit) = name_and_unit(head);
  const auto named = [&](const auto& read) {
    try {
      return read();
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}: column '{}': {}", file, head, error.what())};
    }
  };
  const AllowedColumn& column = named([&]() -> const AllowedColumn& { return column_of(name, allowed); });
  const std::string read_unit = named([&] { return unit_of(unit, column, units); });
  QuantityColumn made{name, column.dimension};
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const double value = value_of(csv.number(row, column_index), read_unit, column, units);
    if (!contains(column.range, value)) {
      throw InputError{fmt::format("{}:{}: column '{}': found '{}'; it must be {}", file, csv.line(row), head,
                                   csv.cell(row, column_index), text_of(column.range))};
    }
    made.values.push_back(value);
  }
  return made;
}

}  // namespace

std::pair<std::string, std::string> name_and_unit(std::string_view head) {
  const std::size_t bracket = head.rfind(" [");
  if (bracket == std::string_view::npos || head.back() != ']') return {std::string{head}, ""};
  return {std::string{head.substr(0, bracket)}, std::string{head.substr(bracket + 2, head.size() - bracket - 3)}};
}

std::vector<QuantityColumn> read_quantity_table(const std::filesystem::path& file,
                                                const std::vector<AllowedColumn>& allowed, const UnitSystem& units) {
  std::vector<QuantityColumn> columns;
  try {
    const records::Csv csv = records::read_csv(file);
    for (std::size_t column_index = 0; column_index < csv.header().size(); ++column_index) {
      QuantityColumn column = read_column(csv, column_index, allowed, units);
      if (std::ranges::find(columns, column.name, &QuantityColumn::name) != columns.end()) {
        throw InputError{fmt::format("{}: column '{}': it is the second one named {}; remove one", file.string(),
                                     csv.header()[column_index], column.name)};
      }
      columns.push_back(std::move(column));
    }
    if (csv.rows() == 0)
      throw InputError{
          fmt::format("{}: found no line below the header; there must be one for each row", file.string())};
  } catch (const records::RecordError& error) {
    throw InputError{error.what()};
  } catch (const records::FileError& error) {
    throw IoError{error.what()};
  }
  return columns;
}

ColumnUnit column_unit(Dimension dimension, const UnitSystem& units) {
  if (dimension == dimension::angle) return {"deg", std::numbers::pi / 180.0};
  return {symbol(units, dimension), si_size(units, dimension)};
}

std::string quantity_csv(const std::vector<QuantityColumn>& columns, const UnitSystem& units) {
  std::vector<std::string> heads;
  for (const QuantityColumn& column : columns)
    heads.push_back(fmt::format("{} [{}]", column.name, column_unit(column.dimension, units).symbol));
  records::CsvText text{heads};
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    for (const QuantityColumn& column : columns)
      text.number(column.values[row] / column_unit(column.dimension, units).size);
    text.end_row();
  }
  return std::move(text).text();
}

}  // namespace talus
