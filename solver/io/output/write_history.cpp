#include "solver/io/output/write_history.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>

#include "solver/base/error.hpp"

namespace talus {

std::string csv_header(const Column& column, const UnitSystem& units) {
  return fmt::format("{} [{}]", column.name, symbol(units, column.dimension));
}

std::string csv(const History& history, const UnitSystem& units) {
  fmt::memory_buffer text;
  const auto separate = [&text](std::size_t column) {
    if (column > 0) text.push_back(',');
  };
  for (std::size_t i = 0; i < history.columns.size(); ++i) {
    separate(i);
    text.append(csv_header(history.columns[i], units));
  }
  text.push_back('\n');
  for (const std::vector<double>& row : history.rows) {
    TALUS_DEMAND(row.size() == history.columns.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      TALUS_DEMAND(std::isfinite(row[i]));
      separate(i);
      fmt::format_to(fmt::appender{text}, FMT_COMPILE("{}"), row[i]);
    }
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

}  // namespace talus
