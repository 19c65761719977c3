#pragma once

#include "verification/check/case.hpp"
#include "verification/problems/swing.hpp"

namespace talus::verification::problems {

/// The order of every integrator on a swing of 60 degrees, and its error against force evaluations: checks and a
/// figure. Faults of bob() and verlet().
void check_work_and_precision(Findings& findings, const Setup& setup);

/// Adds a method's curve to a chart of error against work and, for some methods, the slope of its order.
void draw(const MethodRange& method, const Series& series, Figure& chart);

}  // namespace talus::verification::problems
