#include "solver/geometry/penetration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/geometry/gap.hpp"

namespace talus {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

/// Support function: distance from the centre to the farthest point along m, in the shape's frame [L]; for a
/// superquadric it is the dual norm.
double reach(const Circle& shape, Vec2 m) { return shape.radius * norm(m); }
double reach(const Rectangle& shape, Vec2 m) {
  return shape.half_width * std::abs(m.x) + shape.half_height * std::abs(m.y);
}
double reach(const Superquadric& shape, Vec2 m) {
  const double q = shape.exponent / (shape.exponent - 1.0);
  return gauge({1.0 / shape.half_width, 1.0 / shape.half_height, q}, m);
}

/// The point of the outline farthest along m, in the shape's frame [L]: the gradient of reach().
Vec2 farthest(const Circle& shape, Vec2 m) { return (shape.radius / norm(m)) * m; }
Vec2 farthest(const Rectangle& shape, Vec2 m) {
  return {std::copysign(shape.half_width, m.x), std::copysign(shape.half_height, m.y)};
}
Vec2 farthest(const Superquadric& shape, Vec2 m) {
  const double power = 1.0 / (shape.exponent - 1.0), whole = reach(shape, m);
  const auto part = [&](double half, double along) {
    return std::copysign(half * std::pow(std::abs(half * along) / whole, power), along);
  };
  return {part(shape.half_width, m.x), part(shape.half_height, m.y)};
}

template <class S>
double world_reach(const S& shape, const Pose& pose, Vec2 n) {
  return reach(shape, unrotate(pose.R_WB, n));
}

/// Common extent (overlap) of two convex outlines along the direction n from A to B.
template <class S, class T>
double common(const S& a, const Pose& A, const T& b, const Pose& B, Vec2 n) {
  return world_reach(a, A, n) + world_reach(b, B, -n) - dot(B.p_WB - A.p_WB, n);
}

/// Sharp minima lie at side normals. The smooth minima are bracketed on a grid of equally spaced directions.
template <class S, class T>
double convex(const S& a, const Pose& A, const T& b, const Pose& B) {
  const auto at = [&](Vec2 n) { return common(a, A, b, B, n); };
  double minimum = std::numeric_limits<double>::infinity();
  for (const Rotation R : {A.R_WB, B.R_WB}) {
    for (const Vec2 side : {Vec2{1.0, 0.0}, Vec2{-1.0, 0.0}, Vec2{0.0, 1.0}, Vec2{0.0, -1.0}})
      minimum = std::min(minimum, at(R * side));
  }
  const Vec2 apart = B.p_WB - A.p_WB;
  if (norm(apart) > 0.0) minimum = std::min(minimum, at((1.0 / norm(apart)) * apart));
  constexpr bool boxes = std::is_same_v<S, Rectangle> && std::is_same_v<T, Rectangle>;
  constexpr bool round = std::is_same_v<S, Circle> && std::is_same_v<T, Circle>;
  if constexpr (boxes || round) return minimum;
  constexpr int directions = 64;
  constexpr double part = 2.0 * std::numbers::pi / directions;
  const auto towards = [&](double angle) { return at(rotation(angle) * Vec2{1.0, 0.0}); };
  double best = 0.0, lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < directions; ++i) {
    const double found = towards(part * i);
    if (found < lowest) best = part * i, lowest = found;
  }
  // Golden-section search in the two intervals next to the lowest direction.
  constexpr double golden = 0.6180339887498949;
  double low = best - part, high = best + part;
  for (int i = 0; i < 16; ++i) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    if (towards(left) < towards(right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return std::min({minimum, lowest, towards(0.5 * (low + high))});
}

template <class S>
double below(const S& shape, const Pose& body, const HalfPlane&, const Pose& plane) {
  const Vec2 n = plane.R_WB * Vec2{0.0, 1.0};
  return world_reach(shape, body, -n) - dot(body.p_WB - plane.p_WB, n);
}

template <class S>
double below(const S& shape, const Pose& body, const Terrain& ground, const Pose& under) {
  double deepest = nothing;
  for (const Vec2 point : ground.points) {
    const Vec2 p = unrotate(body.R_WB, world_point(under, point) - body.p_WB);
    // Outside the bounding box of the shape the depth is not positive.
    if (std::abs(p.x) >= reach(shape, {1.0, 0.0}) || std::abs(p.y) >= reach(shape, {0.0, 1.0})) continue;
    deepest = std::max(deepest, depth_below(shape, p).depth);
  }
  // The deepest point of the outline below a segment is the farthest one against the segment's normal.
  for (std::size_t i = 0; i + 1 < ground.points.size(); ++i) {
    const Vec2 along = ground.points[i + 1] - ground.points[i];
    const Vec2 down = under.R_WB * ((1.0 / norm(along)) * Vec2{along.y, -along.x});
    const Vec2 point = world_point(body, farthest(shape, unrotate(body.R_WB, down)));
    deepest = std::max(deepest, depth_below(ground, unrotate(under.R_WB, point - under.p_WB)).depth);
  }
  return deepest;
}

template <class S>
constexpr bool is_body = std::is_same_v<S, Circle> || std::is_same_v<S, Rectangle> || std::is_same_v<S, Superquadric>;
template <class S>
constexpr bool is_ground = std::is_same_v<S, HalfPlane> || std::is_same_v<S, Terrain>;

}  // namespace

double penetration(const Shape& a, const Pose& A, const Shape& b, const Pose& B) {
  return std::visit(
      [&]<class S, class T>(const S& one, const T& other) {
        if constexpr (is_body<S> && is_body<T>) return convex(one, A, other, B);
        if constexpr (is_body<S> && is_ground<T>) return below(one, A, other, B);
        if constexpr (is_ground<S> && is_body<T>) return below(other, B, one, A);
        return nothing;
      },
      a, b);
}

}  // namespace talus
