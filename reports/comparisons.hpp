/// What others use: common formulas and the checks of other codes. All results are Markdown.
#pragma once

#include <string>

#include "reports/record.hpp"

namespace talus::reports {

/// The tables of the cases that set a common formula against what is exact (their names begin with "common_formula").
[[nodiscard]] std::string common_formulas(const Results& results);

/// What other codes and benchmark sets check, and the cases that show the same.
[[nodiscard]] std::string checks_of_peers(const Results& results);

/// What the sources print, and what it must be.
[[nodiscard]] std::string errata(const Results& results);

}  // namespace talus::reports
