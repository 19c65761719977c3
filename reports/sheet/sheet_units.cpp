#include "reports/sheet/sheet_units.hpp"

#include <fmt/format.h>

#include <cmath>

namespace talus::reports {

std::string both(bool us_first, double value, const SheetUnits& units) {
  const std::string si = digits(value / units.si), us = digits(value / units.us);
  return us_first ? fmt::format("{} ({})", us, si) : fmt::format("{} ({})", si, us);
}

std::string with_units(bool us_first, double value, const SheetUnits& units) {
  return fmt::format("{} {} ({} {})", digits(value / (us_first ? units.us : units.si)),
                     us_first ? units.us_name : units.si_name, digits(value / (us_first ? units.si : units.us)),
                     us_first ? units.si_name : units.us_name);
}

std::string unit_names(bool us_first, const SheetUnits& units) {
  return us_first ? fmt::format("{} ({})", units.us_name, units.si_name)
                  : fmt::format("{} ({})", units.si_name, units.us_name);
}

std::string digits(double value) {
  if (value != 0.0 && std::abs(value) >= 1e4 && std::abs(value) < 1e7) return fmt::format("{:.0f}", value);
  return fmt::format("{:.4g}", value);
}

}  // namespace talus::reports
