#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// Errors of the impact at fixed stiffness by velocity Verlet against the soft reference, over the phases of the touch:
/// order, and root mean squares beside the predicted ones, for both end rules, and a figure. Fault `clamped`.
void check_step(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
