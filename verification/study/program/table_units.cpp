#include "verification/study/program/table_units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "verification/record/error.hpp"

namespace talus::verification::problems {
namespace {

constexpr double foot = 0.3048, pound = 4.4482216152605;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A unit of SI, and the size of the US one in it.
struct Unit {
  std::string si;
  double size{};
};

/// By units of tables in US units; "": of texts and counts.
const std::map<std::string, Unit>& units() {
  static const std::map<std::string, Unit> all{{"", {"", 1.0}},
                                               {"s", {"s", 1.0}},
                                               {"1", {"1", 1.0}},
                                               {"rad", {"rad", 1.0}},
                                               {"rad/s", {"rad/s", 1.0}},
                                               {"ft", {"m", foot}},
                                               {"ft/s", {"m/s", foot}},
                                               {"lbf", {"N", pound}},
                                               {"lbf s", {"N s", pound}},
                                               {"lbf ft", {"N m", pound * foot}},
                                               {"lbf/ft", {"N/m", pound / foot}},
                                               {"lb", {"kg", 0.45359237}},
                                               {"lbf/ft^2", {"N/m^2", pound / (foot * foot)}}};
  return all;
}

}  // namespace

TableHead::TableHead(const std::string& head) {
  const std::size_t bracket = head.ends_with(']') ? head.rfind(" [") : std::string::npos;
  name = head.substr(0, bracket);
  if (bracket != std::string::npos) unit = head.substr(bracket + 2, head.size() - bracket - 3);
}

double size_of_unit(const std::string& unit) {
  if (const auto found = units().find(unit); found != units().end()) return found->second.size;
  const bool is_si = std::ranges::any_of(units(), [&](const auto& each) { return each.second.si == unit; });
  return is_si || unit == "J" ? 1.0 : none;
}

double units_error(const records::Csv& in_feet, const records::Csv& in_metres) {
  if (in_feet.rows() != in_metres.rows() || in_feet.header().size() != in_metres.header().size()) return none;
  double worst = 0.0;
  for (std::size_t column = 0; column < in_feet.header().size(); ++column) {
    const std::string& head = in_feet.header()[column];
    const TableHead of{head}, other{in_metres.header()[column]};
    const auto unit = units().find(of.unit);
    if (unit == units().end() || other.name != of.name || other.unit != unit->second.si) return none;
    double largest = 0.0, difference = 0.0;
    for (std::size_t row = 0; row < in_feet.rows(); ++row) {
      if (unit->first.empty() && in_feet.cell(row, column) == in_metres.cell(row, column)) continue;
      try {
        const double metres = in_metres.number(row, column);
        const double by = in_feet.number(row, column) * unit->second.size - metres;
        if (!std::isfinite(by)) return none;
        largest = std::max(largest, std::abs(metres)), difference = std::max(difference, std::abs(by));
      } catch (const records::RecordError&) {
        return none;
      }
    }
    if (difference != 0.0) worst = std::max(worst, difference / largest);
  }
  return worst;
}

}  // namespace talus::verification::problems
