/// What the cases cover, and what they do not. All results are Markdown.
#pragma once

#include <string>

#include "reports/record.hpp"

namespace talus::reports {

/// Laws and their regimes, laws with end rules and methods, integrators and orders, pairs of shapes in contact: how
/// many checks touch each, by the requirements that the cases claim; empty cells say "none".
[[nodiscard]] std::string coverage(const Results& results);

}  // namespace talus::reports
