#pragma once

namespace talus::bench {

/// Prints the time saved by each part of a scene that an evaluation omits, or could omit: a fence's sleeping columns,
/// pairs out of reach, nodes, slack cables. Ratios within one run.
void print_structure_savings();

}  // namespace talus::bench
