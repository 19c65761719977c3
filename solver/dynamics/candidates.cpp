#include "solver/dynamics/candidates.hpp"

#include <cmath>
#include <variant>

namespace talus {
namespace {

Bounds box(const NoShape&) { return {}; }
Bounds box(const Circle& s) { return {s.radius, s.radius, true, false}; }
Bounds box(const Rectangle& s) { return {s.half_width, s.half_height, false, false}; }
Bounds box(const Superquadric& s) { return {s.half_width, s.half_height, false, false}; }
Bounds box(const HalfPlane&) { return {0.0, 0.0, false, true}; }
/// Of ground that goes on for ever no side of a box separates anything.
Bounds box(const Terrain&) { return {1e150, 1e150, true, false}; }

/// Half extents of the box along the axes of a frame in which it stands at R.
Vec2 extent(const Bounds& bounds, Rotation R) {
  if (bounds.round) return {bounds.half_width, bounds.half_height};
  const double c = std::abs(R.cosine), s = std::abs(R.sine);
  return {c * bounds.half_width + s * bounds.half_height, s * bounds.half_width + c * bounds.half_height};
}

/// Whether box A lies beyond a side of box B: the test of separating axes with B's axes.
bool beyond(const Bounds& a, const Pose& A, const Bounds& b, const Pose& B) {
  const Placement seen = placement(A, B);
  const Vec2 reach = extent(a, seen.R);
  return std::abs(seen.p.x) > b.half_width + reach.x || std::abs(seen.p.y) > b.half_height + reach.y;
}

bool above(const Bounds& bounds, const Pose& body, const Pose& plane) {
  const Vec2 n = plane.R_WB * Vec2{0.0, 1.0};
  const Vec2 reach = extent(bounds, body.R_WB);
  return dot(body.p_WB - plane.p_WB, n) > std::abs(n.x) * reach.x + std::abs(n.y) * reach.y;
}

}  // namespace

Bounds bounds(const Shape& shape) {
  return std::visit([](const auto& s) { return box(s); }, shape);
}

bool out_of_reach(const Candidate& pair, const Pose& A, const Pose& B) {
  if (pair.bounds_b.plane) return above(pair.bounds_a, A, B);
  if (pair.bounds_a.plane) return above(pair.bounds_b, B, A);
  if (pair.bounds_b.round) return beyond(pair.bounds_b, B, pair.bounds_a, A);
  return beyond(pair.bounds_a, A, pair.bounds_b, B) ||
         (!pair.bounds_a.round && beyond(pair.bounds_b, B, pair.bounds_a, A));
}

}  // namespace talus
