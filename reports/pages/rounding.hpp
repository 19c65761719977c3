/// The report's table of checks under other rounding modes.
#pragma once

#include <string>

#include "reports/base/record.hpp"
#include "verification/record/audits.hpp"

namespace talus::reports {

/// For each kind of bound the number of checks that fail under each rounding mode, and these checks with their
/// error/bound. `results`: of the reported run, whose cases are linked.
[[nodiscard]] std::string rounding_text(const records::RoundingAudit& audit, const Results& results);

}  // namespace talus::reports
