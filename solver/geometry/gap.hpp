#pragma once

#include "solver/geometry/pose.hpp"
#include "solver/geometry/shape.hpp"

namespace talus {

/// Relative position of two bodies A and B where they are closest.
struct Gap {
  double depth{};  ///< overlap along the normal [L]: > 0 when the bodies interpenetrate, < 0 when they are apart
  Vec2 n_AB;       ///< unit normal from A to B, world components
  Vec2 p_WC;       ///< contact point, world [L]: both contact forces act there, so that moments balance
};

/// Rate of growth of the overlap [L/T]: closing speed, along the normal, of the two bodies' material points at the
/// contact.
constexpr double depth_rate(const Gap& gap, const Pose& A, const Pose& B) {
  return dot(velocity_at(A, gap.p_WC) - velocity_at(B, gap.p_WC), gap.n_AB);
}

/// Position of a point relative to a shape: its depth below the nearest surface (> 0 inside) and the outward unit
/// normal of that surface, both in the shape's frame.
struct Depth {
  double depth{};
  Vec2 normal;
};
[[nodiscard]] inline Depth depth_below(const Circle& shape, Vec2 p) {
  const double distance = norm(p);
  // At the centre no direction is preferred; body x keeps the result finite and repeatable.
  if (distance == 0.0) return {shape.radius, {1.0, 0.0}};
  return {shape.radius - distance, (1.0 / distance) * p};
}
[[nodiscard]] Depth depth_below(const Rectangle& shape, Vec2 p);
[[nodiscard]] Depth depth_below(const Superquadric& shape, Vec2 p);
[[nodiscard]] inline Depth depth_below(const HalfPlane&, Vec2 p) { return {-p.y, {0.0, 1.0}}; }
/// Uses the nearest point of the line; of two equally near points, the first.
[[nodiscard]] Depth depth_below(const Terrain& shape, Vec2 p);

/// A ball of radius `radius` about a point of body A: either a circular body (its centre) or one boundary node (radius
/// 0).
struct Ball {
  Vec2 center_A;    ///< centre in A's coordinates [L]
  double radius{};  ///< [L] >= 0
};

/// Overlap of a ball on A with the shape of B: as in Gap, with the outward unit normal of B's surface in B's frame.
template <class Target>
[[nodiscard]] Depth ball_depth(const Ball& ball, const Placement& A_in_B, const Target& target) {
  const Depth found = depth_below(target, A_in_B.p + A_in_B.R * ball.center_A);
  return {ball.radius + found.depth, found.normal};
}

/// The gap that corresponds to the overlap of a ball with the shape of B.
[[nodiscard]] inline Gap ball_gap(const Ball& ball, const Pose& A, const Depth& found, const Pose& B) {
  const Vec2 n = B.R_WB * found.normal;
  // Half-way through the overlap; any point on the line of the normal gives the same forces and moments.
  return {found.depth, -n, world_point(A, ball.center_A) - (ball.radius - 0.5 * found.depth) * n};
}

/// Gap between a ball on A and the shape of B. Exact whether the ball's centre is outside or inside the shape.
template <class Target>
[[nodiscard]] Gap gap(const Ball& ball, const Pose& A, const Target& target, const Pose& B) {
  return ball_gap(ball, A, ball_depth(ball, placement(A, B), target), B);
}

/// Gap between a superquadric and a half-plane, at the lowest point of the superquadric; exact for every exponent > 1.
[[nodiscard]] Gap gap(const Superquadric& a, const Pose& A, const HalfPlane& b, const Pose& B);

/// Gap between two convex outlines, at least one of them curved; exact to round-off. The normal is the direction of the
/// smallest displacement that separates them (if there are several minima, the smallest); for separate bodies it is the
/// line between the nearest points. The force acts at the deepest points, on the normal through both.
[[nodiscard]] Gap gap(const Superquadric& a, const Pose& A, const Superquadric& b, const Pose& B);
[[nodiscard]] Gap gap(const Rectangle& a, const Pose& A, const Superquadric& b, const Pose& B);

/// Gap between two rectangles along the side normal with the smallest overlap (separating axis theorem), with its
/// deepest point. It is also found when no vertex lies inside the other rectangle. If the rectangles are apart corner
/// to corner, -depth is a lower bound of their distance.
[[nodiscard]] Gap gap(const Rectangle& a, const Pose& A, const Rectangle& b, const Pose& B);

/// One end of the side along which a rectangle touches another. Counter-clockwise about the normal from this rectangle
/// to the other, end 0 lies behind and end 1 ahead.
struct RectangleEnd {
  Rectangle rectangle;
  int end{};
};

/// Gap of two rectangles at one end of the segment shared by their facing sides. A side that lies flat rests on both
/// ends, and the force moves continuously from one end to the other as the side tilts. At each end a corner of one
/// rectangle is below a side of the other, so that a spring there has a potential.
[[nodiscard]] Gap gap(const RectangleEnd& a, const Pose& A, const Rectangle& b, const Pose& B);

}  // namespace talus
