#pragma once

#include <string>

#include "verification/driver/baseline.hpp"

namespace talus::verification {

/// The comparison as text for a terminal or a log: sources, totals by class, a line for each of the first 50 worse
/// items, and the largest changes that are not worse. A few lines if nothing differs.
[[nodiscard]] std::string table_of(const Comparison& comparison);

}  // namespace talus::verification
