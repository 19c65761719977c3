#include "solver/io/output/write_history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "solver/base/error.hpp"

namespace talus {

std::string csv_header(const Column& column, const UnitSystem& units) {
  return fmt::format("{} [{}]", column.name, symbol(units, column.dimension));
}

std::string csv(const History& history, const UnitSystem& units) {
  std::string text;
  for (std::size_t i = 0; i < history.columns.size(); ++i) {
    if (i > 0) text += ',';
    text += csv_header(history.columns[i], units);
  }
  text += '\n';
  for (const std::vector<double>& row : history.rows) {
    TALUS_DEMAND(row.size() == history.columns.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      TALUS_DEMAND(std::isfinite(row[i]));
      if (i > 0) text += ',';
      fmt::format_to(std::back_inserter(text), "{}", row[i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace talus
