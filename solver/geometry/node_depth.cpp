#include "solver/geometry/node_depth.hpp"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

/// Depth below the sides of the box around the outline: not above zero wherever the outline cannot be either.
double box_depth(const Superquadric& shape, Vec2 p) {
  return std::min(shape.half_width - std::abs(p.x), shape.half_height - std::abs(p.y));
}

Vec2 side_normal(Vec2 p) { return {std::copysign(1.0, p.x), 0.0}; }

/// Direction of the gradient of |x/a|^n + |y/b|^n, by the larger term so that nothing overflows.
Vec2 gradient_direction(const Superquadric& shape, Vec2 p) {
  const double u = std::abs(p.x) / shape.half_width;
  const double v = std::abs(p.y) / shape.half_height;
  const double most = std::max(u, v);
  if (most == 0.0) return {1.0, 0.0};
  const double gx = std::copysign(power(u / most, shape.exponent - 1.0) / shape.half_width, p.x);
  const double gy = std::copysign(power(v / most, shape.exponent - 1.0) / shape.half_height, p.y);
  const double length = std::sqrt(gx * gx + gy * gy);
  return {gx / length, gy / length};
}

double ray_depth(const Superquadric& shape, Vec2 p) {
  const double f = gauge(shape, p);
  return f == 0.0 ? std::min(shape.half_width, shape.half_height) : (1.0 / f - 1.0) * norm(p);
}

}  // namespace

Depth depth_below(const SideFaces& shape, Vec2 p) {
  if (const double depth = box_depth(shape.outline, p); depth <= 0.0) return {depth, side_normal(p)};
  if (!is_inside(shape.outline, p)) return {ray_depth(shape.outline, p), side_normal(p)};
  return {shape.outline.half_width - std::abs(p.x), side_normal(p)};
}

Depth depth_below(const CentroidRays& shape, Vec2 p) {
  if (const double depth = box_depth(shape.outline, p); depth <= 0.0) return {depth, side_normal(p)};
  return {ray_depth(shape.outline, p), gradient_direction(shape.outline, p)};
}

}  // namespace talus
