#pragma once

#include <string>

#include "solver/geometry/mass_properties.hpp"
#include "solver/geometry/pose.hpp"
#include "solver/model/body.hpp"
#include "solver/scenes/fence.hpp"

/// Bodies of a model from the elements of a fence.
namespace talus::scenes {

/// Mass and inertia of an element's solid.
[[nodiscard]] MassProperties mass_properties(const FenceElement& e);

/// Number of boundary nodes of an element's whole outline.
[[nodiscard]] int node_count(const FenceElement& e);

/// An element's body, with its name, at its initial position and at rest.
[[nodiscard]] Body body(const FenceElement& e, std::string name, FenceContact contact);

/// Height of a point above the surface of the ground, a half-plane or a terrain in its pose; < 0 below it [L].
[[nodiscard]] double height_over(const Body& ground, const Pose& pose, Vec2 p);

}  // namespace talus::scenes
