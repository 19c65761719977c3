#pragma once

namespace talus::bench {

/// Prints the cost of a step in `talus run` and in the bare loop of the same scene, and the wall time of the whole
/// program.
void print_user_run_costs();

}  // namespace talus::bench
