#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "solver/geometry/gap.hpp"

namespace talus {

/// How deep a node lies in a superquadric, and which way it is pushed out.
enum class NodeDepth {
  nearest,       ///< to the nearest point of the outline, along its normal
  side_face,     ///< inside the outline: to the nearer of its faces x = +-a (FENCE 1993, rock against column)
  smoother,      ///< along the normal of whichever outline bends less at the point (Mustoe & Huttelmaier 1993,
                 ///< Appendix I: "the body with the smoothest tangent plane at the point of contact")
  centroid_ray,  ///< along the ray from the centre, pushed out along the gradient (FENCE 1993, column against column)
};
template <>
struct Names<NodeDepth> {
  static constexpr std::array<std::string_view, 4> list{"nearest", "side_face", "smoother", "centroid_ray"};
};

/// Depth below the sides of the box around an outline [L]: not above zero wherever the outline's cannot be either.
[[nodiscard]] inline double box_depth(const Superquadric& shape, Vec2 p) {
  return std::min(shape.half_width - std::abs(p.x), shape.half_height - std::abs(p.y));
}

/// The outline as seen by the rule `side_face`; outside the depth is negative, no distance.
struct SideFaces {
  Superquadric outline;
};
/// For a point in the box around the outline.
[[nodiscard]] Depth depth_in_box(const SideFaces& shape, Vec2 p);

/// The outline as seen by the rule `smoother` from one node of another outline.
struct Smoother {
  Superquadric outline;
  Vec2 node_normal;         ///< outward, of the node's outline in its own frame
  double node_curvature{};  ///< [1/L]; infinite at a corner
};
/// By the nearest point of the outline; where the node's own outline bends less there, the depth along its normal below
/// the tangent at that point, unless the two normals are more than 60 degrees from opposite.
[[nodiscard]] Depth ball_depth(const Ball& node, const Placement& A_in_B, const Smoother& target);

/// The outline as seen by the rule `centroid_ray`.
struct CentroidRays {
  Superquadric outline;
};
[[nodiscard]] Depth depth_in_box(const CentroidRays& shape, Vec2 p);

/// A rule of 1993: what lies outside the box around the outline is not looked at closer.
template <class Rule>
concept BoxedRule = std::same_as<Rule, SideFaces> || std::same_as<Rule, CentroidRays>;

/// By the rule by which the outline is seen, wherever the point is.
template <BoxedRule Rule>
[[nodiscard]] Depth depth_below(const Rule& shape, Vec2 p) {
  const double depth = box_depth(shape.outline, p);
  return depth <= 0.0 ? Depth{depth, {std::copysign(1.0, p.x), 0.0}} : depth_in_box(shape, p);
}

}  // namespace talus
