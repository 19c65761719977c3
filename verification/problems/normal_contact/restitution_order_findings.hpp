#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// Error of e against the step for a disc on a plane: order one with a dashpot and two without one, whatever the
/// method, and a figure beside the predicted errors. Fault `commensurate_step`.
void check_restitution_orders(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
