#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// The production run of the pivoted cylinder, 100 steps per contact from touch over nearly half a period, and the
/// swing after the impact: compared with elliptic functions from the run's own state, and with the soft reference.
void check_swing(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
