#include "solver/io/output/write_history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "verification/record/csv.hpp"

namespace talus {

std::string csv_header(const Column& column, const UnitSystem& units) {
  return fmt::format("{} [{}]", column.name, symbol(units, column.dimension));
}

std::string csv(const History& history, const UnitSystem& units) {
  std::vector<std::string> names;
  for (const Column& column : history.columns)
    names.push_back(csv_header(column, units));
  records::CsvText text{names};
  for (const std::vector<double>& row : history.rows) {
    for (const double value : row) {
      TALUS_DEMAND(std::isfinite(value));
      text.number(value);
    }
    text.end_row();
  }
  return std::move(text).text();
}

}  // namespace talus
