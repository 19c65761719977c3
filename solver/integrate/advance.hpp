#pragma once

#include "solver/state/state.hpp"

namespace talus {

/// Moves the coordinates with the velocities of the same state: q += h v.
void drift_coordinates(State& state, double h);

/// Advances all that has a rate of its own (velocities, memory, work, impulse) by h times that rate.
void advance_rates(State& state, const Rates& rates, double h);

}  // namespace talus
