#pragma once

#include "solver/cell/cell_run.hpp"

namespace talus::verification::problems {

/// Velocity Verlet with so many steps in a contact, for a time [s] in `loops` LOOPs.
[[nodiscard]] CellPlan cell_plan(const ShearCell& cell, double time, double steps_in_contact = 20.0, int loops = 50);

/// Advances until the end or a failure; what the run is then.
CellRun& run_to_end(CellRun& run);

}  // namespace talus::verification::problems
