#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/granular/sweep_input.hpp"

namespace talus {

/// Numbers of the pairs from <= k < to whose surfaces are nearer than so much; how many. At most sweep_block are asked
/// for at once; beyond those found, `found` is written to up to a pack further.
std::size_t find_near(const DiscSweep& sweep, double nearer, std::size_t from, std::size_t to, std::uint32_t* found);

/// What the pairs do to each other by a law and friction, without doing it. Instantiated for all of DiscLaws
/// (law_sweep.hpp).
template <class L, class F>
void find_pushes(const L& law, const F& friction, const DiscSweep& sweep, DiscPushes& pushes);

/// Kicks the discs, if it is to, and drifts those that do not turn; the largest square of the own speeds of those that
/// have moved. Instantiated for all of DiscLaws.
template <class L, class F>
double sweep_discs(const L& law, const F& friction, const DiscSweep& sweep);

/// Gives second discs that are of this sweep what others' first discs do to them.
void receive(const DiscSweep& sweep, const DiscPushes& pushes);

/// Stretches the springs of friction over the drift, before the discs move.
void stretch_contacts(const DiscSweep& sweep);

/// Moves the discs; the largest square of their own speeds.
double move_discs(const DiscSweep& sweep);

}  // namespace talus
