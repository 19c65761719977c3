#pragma once

#include "solver/scenes/fence_scene.hpp"
#include "solver/scenes/scene.hpp"

/// Scenes with many events in a short time, for the cases on invariance under a change of viewpoint.
namespace talus::verification::problems {

/// Bodies of every shape thrown at each other over uneven ground and against a wall, with nodal and resultant contacts
/// and friction; a pinned bar, a carriage on rails and a bob on cables that yield, harden and break; a hanger that
/// breaks. All of it happens within two seconds.
[[nodiscard]] Scene mixed_pile();

/// The fence of Table 2 of 1993 with friction, cables that yield and hangers that break, hit by a spinning rock.
[[nodiscard]] scenes::Fence rough_fence();

/// Four bodies in free flight that meet: three discs and a plate, with friction, two of them connected by a cable. No
/// external forces act.
[[nodiscard]] Scene free_group();

/// Number of loss mechanisms that have dissipated energy up to this state.
[[nodiscard]] int mechanisms_at_work(const State& state);

}  // namespace talus::verification::problems
