#pragma once

namespace talus::bench {

/// Prints the cost of reading scenes of many bodies.
void print_reading_costs();

}  // namespace talus::bench
