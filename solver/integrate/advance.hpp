#pragma once

#include "solver/state/state.hpp"

namespace talus {

/// Moves the coordinates with the velocities of the same state: q += h v.
void drift_coordinates(State& state, double h);

/// Advances work and impulse by h times their rates.
void book_rates(State& state, const Rates& rates, double h);

/// Advances velocities, work and impulse by h times their rates.
void kick_velocities(State& state, const Rates& rates, double h);

/// The same with the memory: all that has a rate of its own.
void advance_rates(State& state, const Rates& rates, double h);

}  // namespace talus
