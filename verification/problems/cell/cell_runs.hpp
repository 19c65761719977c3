#pragma once

#include <functional>

#include "solver/cell/cell_run.hpp"

namespace talus::verification::problems {

/// Plan of a run of `time` [s] in `loops` LOOPs, with `steps_in_contact` steps in a contact and the default integrator,
/// central difference.
[[nodiscard]] CellPlan cell_plan(const ShearCell& cell, double time, double steps_in_contact = 20.0, int loops = 50);

/// Advances the run to its end or to a failure, and returns it. Calls `at_output`, if any, when output is due.
CellRun& run_to_end(CellRun& run, const std::function<void(CellRun&)>& at_output = {});

}  // namespace talus::verification::problems
