#pragma once

#include <string>
#include <string_view>

#include "solver/base/dimension.hpp"
#include "solver/base/units.hpp"

namespace talus::app {

/// A line of text without its end: a name, padded to `width` letters, and a value with its unit.
[[nodiscard]] std::string value_line(int width, std::string_view name, double value, std::string_view unit);

/// Prints lines of values in the units of a system, angles in degrees.
class ValueLines {
 public:
  /// `width` of the names.
  ValueLines(int width, const UnitSystem& units) : width_{width}, units_{units} {}
  void operator()(std::string_view name, double in_si, Dimension dimension) const;

 private:
  int width_;
  UnitSystem units_;
};

}  // namespace talus::app
