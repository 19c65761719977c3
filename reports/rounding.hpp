/// The report's table of checks under other roundings.
#pragma once

#include <map>
#include <string>

#include "reports/record.hpp"

namespace talus::reports {

/// Results of the same cases by the rounding that they were run with: "upward", "downward", "toward_zero".
using RoundedResults = std::map<std::string, Results>;

/// For each kind of bound how many checks fail under each rounding, and those checks with their error/bound.
/// `nearest`: the run that the report is about.
[[nodiscard]] std::string rounding_text(const Results& nearest, const RoundedResults& rounded);

}  // namespace talus::reports
