#pragma once

namespace talus::bench {

/// Prints what a step costs in `talus run`, beside the bare loop of the same scene, and the wall time of the whole
/// program.
void print_user_run_costs();

}  // namespace talus::bench
