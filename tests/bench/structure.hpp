#pragma once

namespace talus::bench {

/// Prints what each part of a scene that is left out of an evaluation saves, or would save if it were: a fence's
/// sleeping columns, pairs out of reach, nodes, slack cables. Ratios within one run.
void print_structure_savings();

}  // namespace talus::bench
