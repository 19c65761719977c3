#pragma once

namespace talus::bench {

/// Prints the cost of finding the pairs within reach: by checking each pair, by listing the close pairs, and with a
/// list that is still valid.
void print_search_costs();

}  // namespace talus::bench
