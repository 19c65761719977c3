#pragma once

namespace talus::bench {

/// Prints what finding the pairs within reach costs: by looking at each, by listing those that are close, and while
/// that list stands.
void print_search_costs();

}  // namespace talus::bench
