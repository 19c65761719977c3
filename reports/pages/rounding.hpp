/// The report's table of checks under other rounding modes.
#pragma once

#include <map>
#include <string>

#include "reports/base/record.hpp"

namespace talus::reports {

/// Results of the same cases by rounding mode of the run: "upward", "downward", "toward_zero".
using RoundedResults = std::map<std::string, Results>;

/// For each kind of bound the number of checks that fail under each rounding mode, and these checks with their
/// error/bound. `nearest`: results of the reported run.
[[nodiscard]] std::string rounding_text(const Results& nearest, const RoundedResults& rounded);

}  // namespace talus::reports
