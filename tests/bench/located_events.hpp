#pragma once

namespace talus::bench {

/// Prints what located events cost: where none happens, against the same method that does not look for any; and for
/// the fence of Table 2 to .2 s, with all guards and with those that may end within the next steps.
void print_event_costs();

}  // namespace talus::bench
