/// Comparisons with others: common formulas and the checks of other codes. All results are Markdown.
#pragma once

#include <string>

#include "reports/base/record.hpp"

namespace talus::reports {

/// The tables of the cases that compare a common formula with the exact result (their names begin with
/// "common_formula").
[[nodiscard]] std::string common_formulas(const Results& results);

/// The checks of other codes and benchmark sets, with the cases that cover the same.
[[nodiscard]] std::string checks_of_peers(const Results& results);

/// Errata: the printed values of the sources, and the correct ones.
[[nodiscard]] std::string errata(const Results& results);

}  // namespace talus::reports
