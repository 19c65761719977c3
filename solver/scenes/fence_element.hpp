#pragma once

#include <string>

#include "solver/geometry/mass_properties.hpp"
#include "solver/geometry/pose.hpp"
#include "solver/model/body.hpp"
#include "solver/scenes/fence.hpp"

/// What an element of a fence is in a model.
namespace talus::scenes {

/// Mass and inertia of its solid.
[[nodiscard]] MassProperties mass_properties(const FenceElement& e);

/// Boundary nodes of its whole outline.
[[nodiscard]] int node_count(const FenceElement& e);

/// Its body, named and at its place, at rest.
[[nodiscard]] Body body(const FenceElement& e, std::string name, FenceContact contact);

/// Height of a point over the surface of the ground, a level or a terrain in its pose; < 0 below it [L].
[[nodiscard]] double height_over(const Body& ground, const Pose& pose, Vec2 p);

}  // namespace talus::scenes
