#pragma once

#include "verification/check/findings.hpp"

namespace talus::verification::problems {

/// What the 1993 report prints of the pivoted cylinder beside its corrected equations and the solver: tables, and the
/// setting that gives all three printed numbers.
void check_report_of_1993(Findings& findings);

}  // namespace talus::verification::problems
