#pragma once

#include "solver/geometry/gap.hpp"

namespace talus {

/// How deep a node lies in a superquadric, and which way it is pushed out.
enum class NodeDepth {
  nearest,       ///< to the nearest point of the outline, along its normal
  side_face,     ///< inside the outline: to the nearer of its faces x = +-a (FENCE 1993, rock against column)
  centroid_ray,  ///< along the ray from the centre, pushed out along the gradient (FENCE 1993, column against column)
};
template <>
struct Names<NodeDepth> {
  static constexpr std::array<std::string_view, 3> list{"nearest", "side_face", "centroid_ray"};
};

/// The outline as seen by the rule `side_face`; outside the depth is negative, no distance.
struct SideFaces {
  Superquadric outline;
};
[[nodiscard]] Depth depth_below(const SideFaces& shape, Vec2 p);

/// The outline as seen by the rule `centroid_ray`.
struct CentroidRays {
  Superquadric outline;
};
[[nodiscard]] Depth depth_below(const CentroidRays& shape, Vec2 p);

}  // namespace talus
