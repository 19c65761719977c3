#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "solver/geometry/gap.hpp"

namespace talus {

/// Rules for the depth of a node in a superquadric and for the direction that pushes it out.
enum class NodeDepth {
  nearest,       ///< depth to the nearest point of the outline, along its normal
  side_face,     ///< inside the outline: depth to the nearer of the faces x = +-a (FENCE 1993, rock against column)
  smoother,      ///< along the normal of the outline with the smaller curvature at the point (Mustoe & Huttelmaier
                 ///< 1993, Appendix I: "the body with the smoothest tangent plane at the point of contact")
  centroid_ray,  ///< along the ray from the centre; push along the gradient (FENCE 1993, column against column)
};
template <>
struct Names<NodeDepth> {
  static constexpr std::array<std::string_view, 4> list{"nearest", "side_face", "smoother", "centroid_ray"};
};

/// Depth below the sides of the outline's bounding box [L]; where it is not positive, neither is the outline's.
[[nodiscard]] inline double box_depth(const Superquadric& shape, Vec2 p) {
  return std::min(shape.half_width - std::abs(p.x), shape.half_height - std::abs(p.y));
}

/// The outline under the rule `side_face`. Outside the outline the depth is negative, but it is not a distance.
struct SideFaces {
  Superquadric outline;
};
/// For a point inside the bounding box of the outline.
[[nodiscard]] Depth depth_in_box(const SideFaces& shape, Vec2 p);

/// The outline under the rule `smoother`, for one node of another outline.
struct Smoother {
  Superquadric outline;
  Vec2 node_normal;         ///< outward normal of the node's outline, in that outline's frame
  double node_curvature{};  ///< [1/L]; infinite at a corner
};
/// Depth by the nearest point of the outline. Where the node's own outline has the smaller curvature there, the depth
/// is measured along the node's normal, down from the tangent at that point, unless the two normals are more than 60
/// degrees from opposite.
[[nodiscard]] Depth ball_depth(const Ball& node, const Placement& A_in_B, const Smoother& target);

/// The outline under the rule `centroid_ray`.
struct CentroidRays {
  Superquadric outline;
};
[[nodiscard]] Depth depth_in_box(const CentroidRays& shape, Vec2 p);

/// A 1993 rule that evaluates only points inside the bounding box of the outline.
template <class Rule>
concept BoxedRule = std::same_as<Rule, SideFaces> || std::same_as<Rule, CentroidRays>;

/// Depth by the outline's rule, for any point.
template <BoxedRule Rule>
[[nodiscard]] Depth depth_below(const Rule& shape, Vec2 p) {
  const double depth = box_depth(shape.outline, p);
  return depth <= 0.0 ? Depth{depth, {std::copysign(1.0, p.x), 0.0}} : depth_in_box(shape, p);
}

}  // namespace talus
