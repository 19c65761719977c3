#pragma once

#include <vector>

#include "solver/model/body.hpp"

namespace talus {

/// The outline of a body in its own axes, as it is drawn: poly line, the first point again at the end. Ground is a line
/// of its own: terrain its points, a half-plane's goes `reach` [L] to both sides. A pinned body without a shape is its
/// arm; another without a shape has none.
[[nodiscard]] std::vector<Vec2> outline(const Body& body, double reach);

}  // namespace talus
