#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/granular/sweep_input.hpp"

namespace talus {

/// Numbers of the pairs from <= k < to whose surfaces are nearer than so much; how many. At most sweep_block are asked
/// for at once; beyond those found, `found` is written to up to a pack further.
std::size_t find_near(const StepBlock& sweep, double nearer, std::size_t from, std::size_t to, std::uint32_t* found);

/// What the pairs do to each other by a law and friction, without doing it. Instantiated for all of DiscLaws
/// (law_sweep.hpp).
template <class L, class F>
void evaluate_pair_forces(const L& law, const F& friction, const StepBlock& sweep, PairForces& pushes);

/// Kicks the discs, if it is to, and drifts those that do not turn; the largest square of the own speeds of those that
/// have moved. Instantiated for all of DiscLaws.
template <class L, class F>
double kick_and_drift(const L& law, const F& friction, const StepBlock& sweep);

/// Gives second discs that are of this sweep what others' first discs do to them.
void apply_incoming(const StepBlock& sweep, const PairForces& pushes);

/// Stretches the springs of friction over the drift, before the discs move.
void stretch_contacts(const StepBlock& sweep);

/// Moves the discs; the largest square of their own speeds.
double move_discs(const StepBlock& sweep);

}  // namespace talus
