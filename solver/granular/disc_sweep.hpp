#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/granular/sweep_input.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"

namespace talus {

/// Numbers of the pairs from <= k < to whose surfaces are nearer than so much; how many. At most sweep_block are asked
/// for at once; beyond those found, `found` is written to up to a pack further.
std::size_t find_near(const DiscSweep& sweep, double nearer, std::size_t from, std::size_t to, std::uint32_t* found);

/// What the pairs do to each other, without doing it.
void find_pushes(const LinearSpringDashpot&, const Frictionless&, const DiscSweep&, DiscPushes&);
void find_pushes(const LinearSpringDashpot&, const CoulombFriction&, const DiscSweep&, DiscPushes&);
void find_pushes(const LatchingSpring&, const Frictionless&, const DiscSweep&, DiscPushes&);
void find_pushes(const LatchingSpring&, const CoulombFriction&, const DiscSweep&, DiscPushes&);

/// Kicks the discs, if it is to, and drifts those that do not turn; the largest square of the own speeds of those that
/// have moved.
double sweep_discs(const LinearSpringDashpot&, const Frictionless&, const DiscSweep&);
double sweep_discs(const LinearSpringDashpot&, const CoulombFriction&, const DiscSweep&);
double sweep_discs(const LatchingSpring&, const Frictionless&, const DiscSweep&);
double sweep_discs(const LatchingSpring&, const CoulombFriction&, const DiscSweep&);

/// Gives second discs that are of this sweep what others' first discs do to them.
void receive(const DiscSweep& sweep, const DiscPushes& pushes);

/// Stretches the springs of friction over the drift, before the discs move.
void stretch_contacts(const DiscSweep& sweep);

/// Moves the discs; the largest square of their own speeds.
double move_discs(const DiscSweep& sweep);

}  // namespace talus
