#pragma once

#include <vector>

#include "solver/model/body.hpp"

namespace talus {

/// Outline of a body in its body coordinates, for drawing: a polyline that repeats its first point at the end. Ground
/// is an open line: the points of a terrain; for a half-plane a line that extends by `reach` [L] to both sides. A
/// pinned or guided body without a shape is drawn as its arm; other bodies without a shape have no outline.
[[nodiscard]] std::vector<Vec2> outline(const Body& body, double reach);

}  // namespace talus
