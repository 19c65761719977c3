#pragma once

namespace talus::bench {

/// Prints what finding the pairs within reach costs one by one and by the sweep: which of the two the search takes by
/// the number of pairs rests on this table.
void print_search_costs();

}  // namespace talus::bench
