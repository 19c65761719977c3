#pragma once

#include "solver/scenes/fence_scene.hpp"
#include "solver/scenes/scene.hpp"

/// Scenes in which much happens in a short time, for the cases on what a change of viewpoint must leave as it is.
namespace talus::verification::problems {

/// Bodies of every shape thrown at each other over uneven ground and against a wall, by nodes and by resultants, with
/// friction; a pinned bar, a carriage on rails and a bob on cables that yield, harden and break; a hanger that breaks.
/// Two seconds hold all of it.
[[nodiscard]] Scene crowded_yard();

/// The fence of Table 2 of 1993 with friction, cables that yield and hangers that break, hit by a rock with spin.
[[nodiscard]] scenes::Fence rough_fence();

/// Four bodies in free flight that meet: three discs and a plate, with friction, two of them on a cable. Nothing from
/// outside acts.
[[nodiscard]] Scene free_group();

/// How many mechanisms of loss have taken energy by this state.
[[nodiscard]] int mechanisms_at_work(const State& state);

}  // namespace talus::verification::problems
