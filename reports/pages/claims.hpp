/// What may be claimed from the cases: the kinds of evidence that they rest on. All results are Markdown.
#pragma once

#include <string>

#include "reports/base/record.hpp"

namespace talus::reports {

/// The kinds of evidence, the strongest first: what may and may not be claimed from a case of each, the number of cases
/// that rest on it, and of those for which it is the strongest; then the latter by family.
[[nodiscard]] std::string ladder_of_claims(const Results& results);

/// Each case: its evidence, its conclusion, and what it does not show.
[[nodiscard]] std::string claims_of_cases(const Results& results);

}  // namespace talus::reports
