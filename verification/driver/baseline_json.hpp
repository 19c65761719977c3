#pragma once

#include <string>

#include "verification/driver/baseline.hpp"

namespace talus::verification {

/// The JSON text of baseline.json (schema 1): both sources, the allowed differences, totals, and every case, check and
/// control with both values, their change and the reasons why it is worse.
[[nodiscard]] std::string json_of(const Comparison& comparison);

}  // namespace talus::verification
