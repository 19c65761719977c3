#pragma once

#include "solver/geometry/pose.hpp"
#include "solver/geometry/shape.hpp"

namespace talus {

/// How two bodies A and B stand to each other where they are closest.
struct Gap {
  double depth{};  ///< overlap along the normal [L]: > 0 when the bodies interpenetrate, < 0 when they are apart
  Vec2 n_AB;       ///< unit normal from A to B, world components
  Vec2 p_WC;       ///< contact point, world [L]: where one force acts on both bodies, so that moments balance
};

/// Rate at which the overlap grows [L/T]: the speed of approach of the bodies' points at the contact, along the normal.
constexpr double depth_rate(const Gap& gap, const Pose& A, const Pose& B) {
  return dot(velocity_at(A, gap.p_WC) - velocity_at(B, gap.p_WC), gap.n_AB);
}

/// Where a point lies with respect to a shape: its depth below the nearest surface (> 0 inside) and that surface's
/// outward unit normal, both in the shape's own frame.
struct Depth {
  double depth{};
  Vec2 normal;
};
[[nodiscard]] inline Depth depth_below(const Circle& shape, Vec2 p) {
  const double distance = norm(p);
  // At the very centre every direction is as good; body x keeps the answer finite and repeatable.
  if (distance == 0.0) return {shape.radius, {1.0, 0.0}};
  return {shape.radius - distance, (1.0 / distance) * p};
}
[[nodiscard]] Depth depth_below(const Rectangle& shape, Vec2 p);
[[nodiscard]] Depth depth_below(const Superquadric& shape, Vec2 p);
[[nodiscard]] inline Depth depth_below(const HalfPlane&, Vec2 p) { return {-p.y, {0.0, 1.0}}; }
/// By the nearest point of the line; of two equally near ones the first.
[[nodiscard]] Depth depth_below(const Terrain& shape, Vec2 p);

/// A ball of radius `radius` about the point p_A of body A: a circular body (its centre) or one boundary node (radius
/// 0).
struct Ball {
  Vec2 center_A;    ///< centre in A's coordinates [L]
  double radius{};  ///< [L] >= 0
};

/// Depth of a ball on A in the shape of B: as in Gap, with the outward unit normal of B's surface in B's own frame.
template <class Target>
[[nodiscard]] Depth ball_depth(const Ball& ball, const Placement& A_in_B, const Target& target) {
  const Depth found = depth_below(target, A_in_B.p + A_in_B.R * ball.center_A);
  return {ball.radius + found.depth, found.normal};
}

/// The gap that belongs to a ball's depth in the shape of B.
[[nodiscard]] inline Gap ball_gap(const Ball& ball, const Pose& A, const Depth& found, const Pose& B) {
  const Vec2 n = B.R_WB * found.normal;
  // Half-way through the overlap; any point of the normal's line gives the same forces and moments.
  return {found.depth, -n, world_point(A, ball.center_A) - (ball.radius - 0.5 * found.depth) * n};
}

/// Gap between a ball on A and the shape of B. Exact for a ball outside and for one whose centre is inside.
template <class Target>
[[nodiscard]] Gap gap(const Ball& ball, const Pose& A, const Target& target, const Pose& B) {
  return ball_gap(ball, A, ball_depth(ball, placement(A, B), target), B);
}

/// Gap between a superquadric and a half-plane: at the lowest point, exact for every exponent > 1.
[[nodiscard]] Gap gap(const Superquadric& a, const Pose& A, const HalfPlane& b, const Pose& B);

/// Gap between two convex outlines, at least one of them curved: along the direction in which the least displacement
/// parts them (touching, of several the shortest), exact to round-off; of bodies apart, the one between the nearest
/// points. The force acts at the deepest points, on the normal's line through both.
[[nodiscard]] Gap gap(const Superquadric& a, const Pose& A, const Superquadric& b, const Pose& B);
[[nodiscard]] Gap gap(const Rectangle& a, const Pose& A, const Superquadric& b, const Pose& B);

/// Gap between two rectangles along the side normal of least overlap (separating axes), with its deepest point; found
/// without a vertex inside, too. When the rectangles are apart corner to corner, -depth is a lower bound of their
/// distance.
[[nodiscard]] Gap gap(const Rectangle& a, const Pose& A, const Rectangle& b, const Pose& B);

/// One end of the side along which a rectangle touches another: the one behind (0) or ahead (1) counter-clockwise of
/// the normal from it to the other.
struct RectangleEnd {
  Rectangle rectangle;
  int end{};
};

/// Gap of two rectangles at one end of the part that their facing sides have in common. A side that lies flat rests on
/// both ends, and the force moves from one to the other continuously as it tilts. At each end a corner of one rectangle
/// is below a side of the other, so that a spring there has a potential.
[[nodiscard]] Gap gap(const RectangleEnd& a, const Pose& A, const Rectangle& b, const Pose& B);

}  // namespace talus
