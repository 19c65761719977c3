/// The first pages of the report. All results are Markdown.
#pragma once

#include <string>

#include "reports/base/record.hpp"

namespace talus::reports {

/// Checks that failed, controls that did not turn red, and interrupted cases; empty if there are none.
[[nodiscard]] std::string failures(const Results& results);

/// One row per case, family by family, with the totals of each family above its cases.
[[nodiscard]] std::string summary_by_family(const Results& results);

}  // namespace talus::reports
