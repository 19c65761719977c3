/// The report's first pages. All results are Markdown.
#pragma once

#include <string>

#include "reports/record.hpp"

namespace talus::reports {

/// Checks that failed, controls that did not turn red, and cases that broke off; empty if there are none.
[[nodiscard]] std::string failures(const Results& results);

/// One row a case, family by family, with the sums of each family above its cases.
[[nodiscard]] std::string summary_by_family(const Results& results);

}  // namespace talus::reports
