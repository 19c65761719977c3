#include "solver/app/calibration/value_lines.hpp"

#include <fmt/format.h>

#include "solver/io/file/quantity_table.hpp"

namespace talus::app {

std::string value_line(int width, std::string_view name, double value, std::string_view unit) {
  return fmt::format("  {:<{}}{:>16.9g} {}", name, width, value, unit);
}

void ValueLines::operator()(std::string_view name, double in_si, Dimension dimension) const {
  const ColumnUnit unit = column_unit(dimension, units_);
  fmt::print("{}\n", value_line(width_, name, in_si / unit.size, unit.symbol));
}

}  // namespace talus::app
