#pragma once

#include "verification/check/case.hpp"
#include "verification/study/runs/swing.hpp"

namespace talus::verification::problems {

/// The order of every integrator on an oscillation of 60 degrees, and its error against force evaluations: checks and a
/// figure. Faults of bob() and verlet().
void check_work_and_precision(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
