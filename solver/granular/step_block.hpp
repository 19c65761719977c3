#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/granular/sweep_input.hpp"

namespace talus {

/// Writes to `found` the indices of the pairs from <= k < to whose surface gap is below `nearer` [L], and returns their
/// count. At most sweep_block pairs in one call; up to a pack of `found` behind the last index is overwritten.
std::size_t find_near(const StepBlock& sweep, double nearer, std::size_t from, std::size_t to, std::uint32_t* found);

/// Evaluates the forces of the pairs by a law and friction without applying them. Instantiated for all laws of DiscLaws
/// (law_sweep.hpp).
template <class L, class F>
void evaluate_pair_forces(const L& law, const F& friction, const StepBlock& sweep, PairForces& pushes);

/// Kicks the discs if sweep.kicks, drifts those that do not turn, and returns the largest squared speed, relative to
/// the mean flow, of the discs that moved [L^2/T^2]. Instantiated for all laws of DiscLaws.
template <class L, class F>
double kick_and_drift(const L& law, const F& friction, const StepBlock& sweep);

/// Applies the forces of pairs whose first disc is in another block to those second discs that are in this block.
void apply_incoming(const StepBlock& sweep, const PairForces& pushes);

/// Moves the stretch of the friction springs by the slip of the drift, before the discs move. Instantiated for all of
/// DiscFrictions.
template <class F>
void stretch_contacts(const F& friction, const StepBlock& sweep);

/// Moves the discs; returns their largest squared speed relative to the mean flow [L^2/T^2].
double move_discs(const StepBlock& sweep);

}  // namespace talus
