#pragma once

#include <string>

#include "solver/base/units.hpp"
#include "solver/run/history.hpp"

namespace talus {

/// Header of a column: "rock.x [ft]".
[[nodiscard]] std::string csv_header(const Column& column, const UnitSystem& units);

/// A history as CSV: a header with units, then one line for each row; each number has the fewest digits from which the
/// same double is read. All numbers must be finite.
[[nodiscard]] std::string csv(const History& history, const UnitSystem& units);

}  // namespace talus
