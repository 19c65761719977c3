#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// The production run of the pivoted cylinder, 100 steps per contact from touch to the end of half a swing, and the
/// swing after the impact: against elliptic functions from the run's own state, and against the soft reference.
void check_swing(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
