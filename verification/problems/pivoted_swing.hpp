#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// The production run of the pivoted cylinder, 100 steps per contact from touch to the end of half a swing, and the
/// swing after the impact: against elliptic functions from the run's own state, and against the soft reference.
void check_swing(Findings& findings, const Setup& setup);

/// What the 1993 report prints beside its corrected equations and the solver: tables, and the setting that gives all
/// three printed numbers.
void check_report_of_1993(Findings& findings);

}  // namespace talus::verification::problems
