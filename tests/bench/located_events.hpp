#pragma once

namespace talus::bench {

/// Prints the cost of located events: where none happens, compared with the same method without event location; and for
/// the fence of Table 2 to 0.2 s, with all guards and with those that may end within the next steps.
void print_event_costs();

}  // namespace talus::bench
