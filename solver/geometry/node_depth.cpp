#include "solver/geometry/node_depth.hpp"

#include <algorithm>

namespace talus {
namespace {

/// |x/a|^n + |y/b|^n and the direction of its gradient, for a point in the bounding box of the outline.
struct Powers {
  double sum{};
  Vec2 gradient;  ///< divided by n
};

Powers powers(const Superquadric& shape, Vec2 p) {
  const double u = std::abs(p.x) / shape.half_width;
  const double v = std::abs(p.y) / shape.half_height;
  const double u_less = power(u, shape.exponent - 1.0);
  const double v_less = power(v, shape.exponent - 1.0);
  return {u * u_less + v * v_less,
          {std::copysign(u_less / shape.half_width, p.x), std::copysign(v_less / shape.half_height, p.y)}};
}

/// Depth of a point outside the outline, to first order in its distance along the ray: negative, zero on the outline.
double depth_outside(double sum, double exponent, Vec2 p) { return (1.0 - sum) / exponent * norm(p); }

}  // namespace

Depth depth_in_box(const SideFaces& shape, Vec2 p) {
  const Vec2 normal{std::copysign(1.0, p.x), 0.0};
  const double sum = powers(shape.outline, p).sum;
  if (sum >= 1.0) return {depth_outside(sum, shape.outline.exponent, p), normal};
  return {shape.outline.half_width - std::abs(p.x), normal};
}

Depth ball_depth(const Ball& node, const Placement& A_in_B, const Smoother& target) {
  const Vec2 p = A_in_B.p + A_in_B.R * node.center_A;
  const Depth found = depth_below(target.outline, p);
  if (curvature(target.outline, p + found.depth * found.normal) <= target.node_curvature) return found;
  const Vec2 normal = -(A_in_B.R * target.node_normal);
  const double cosine = dot(normal, found.normal);
  return cosine < 0.5 ? found : Depth{found.depth / cosine, normal};
}

Depth depth_in_box(const CentroidRays& shape, Vec2 p) {
  const auto [sum, gradient] = powers(shape.outline, p);
  const double length = norm(gradient);
  // At the centre, and so close to it that the powers underflow, no direction is preferred.
  const Vec2 normal = length > 0.0 ? (1.0 / length) * gradient : Vec2{1.0, 0.0};
  if (sum >= 1.0) return {depth_outside(sum, shape.outline.exponent, p), normal};
  const double f = gauge(shape.outline, p);
  return {f == 0.0 ? std::min(shape.outline.half_width, shape.outline.half_height) : (1.0 / f - 1.0) * norm(p), normal};
}

}  // namespace talus
