#include "solver/io/file/json_number.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace talus {

nlohmann::ordered_json json_number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

}  // namespace talus
