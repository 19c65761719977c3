#include "verification/record/json_number.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace talus::records {

nlohmann::ordered_json json_number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

std::optional<double> not_finite_named(std::string_view name) {
  using Limits = std::numeric_limits<double>;
  if (name == "nan") return Limits::quiet_NaN();
  if (name == "inf") return Limits::infinity();
  if (name == "-inf") return -Limits::infinity();
  return {};
}

}  // namespace talus::records
