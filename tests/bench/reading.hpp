#pragma once

namespace talus::bench {

/// Prints what reading scenes of many bodies costs.
void print_reading_costs();

}  // namespace talus::bench
