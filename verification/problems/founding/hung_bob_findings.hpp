#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// The bob on a cable whose stiffness grows: period against that of the rigid pendulum, with the predicted slope.
/// Fault `cable_stiffness_doubled`.
void check_rigid_limit(Findings& findings, const Setup& setup);

/// The bob on a cable of one fixed stiffness against the elastic reference: only the step separates the two.
void check_elastic(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
