#include "solver/geometry/gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace talus {
namespace {

constexpr double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

std::array<Vec2, 4> world_corners(const Rectangle& box, const Pose& pose) {
  const double a = box.half_width, b = box.half_height;
  return {world_point(pose, {a, b}), world_point(pose, {-a, b}), world_point(pose, {-a, -b}),
          world_point(pose, {a, -b})};
}

/// A side of a rectangle in the world frame: outward normal, tangent, midpoint, half-length.
struct Side {
  Vec2 n;
  Vec2 t;
  Vec2 middle;
  double half_length;
};

Side side(const Rectangle& box, const Pose& pose, int i) {
  const bool upright = i % 2 == 0;  // the normals of sides 0 and 2 are +-x, those of 1 and 3 +-y
  const double s = i < 2 ? 1.0 : -1.0;
  const Vec2 n = pose.R_WB * (upright ? Vec2{s, 0.0} : Vec2{0.0, s});
  const double reach = upright ? box.half_width : box.half_height;
  return {n, {-n.y, n.x}, pose.p_WB + reach * n, upright ? box.half_height : box.half_width};
}

struct Overlap {
  double depth{std::numeric_limits<double>::infinity()};
  Side face{};
};

/// The side of the box with the smallest overlap: the largest depth of a corner below it is the smallest.
Overlap minimum_overlap(const Rectangle& box, const Pose& pose, const std::array<Vec2, 4>& corners) {
  Overlap smallest;
  for (int i = 0; i < 4; ++i) {
    const Side face = side(box, pose, i);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec2 corner : corners)
      lowest = std::min(lowest, dot(corner - face.middle, face.n));
    if (-lowest < smallest.depth) smallest = {-lowest, face};
  }
  return smallest;
}

/// The facing sides of two rectangles: the face that the other rectangle overlaps least, and the side of the other
/// rectangle whose normal is most nearly opposite.
struct Facing {
  double depth{};    ///< of the other rectangle's deepest corner below the face [L]
  bool face_of_b{};  ///< otherwise it is a side of a
  Side face;
  Side other;

  Vec2 n_AB() const { return face_of_b ? -face.n : face.n; }
};

Side facing_side(const Side& face, const Rectangle& box, const Pose& pose) {
  Side found = side(box, pose, 0);
  for (int i = 1; i < 4; ++i) {
    const Side other = side(box, pose, i);
    if (dot(other.n, face.n) < dot(found.n, face.n)) found = other;
  }
  return found;
}

Facing facing(const Rectangle& a, const Pose& A, const Rectangle& b, const Pose& B) {
  const Overlap below_b = minimum_overlap(b, B, world_corners(a, A));
  const Overlap below_a = minimum_overlap(a, A, world_corners(b, B));
  if (below_b.depth <= below_a.depth) return {below_b.depth, true, below_b.face, facing_side(below_b.face, a, A)};
  return {below_a.depth, false, below_a.face, facing_side(below_a.face, b, B)};
}

/// The gap at one end of the face, behind (-1) or ahead (1) along its tangent. Each of the two sides has a corner
/// there; the corner nearer to the middle is used, measured along the line half-way between both sides. Where the
/// corners pass each other along that line they are equally deep below the sides, so that the depth is continuous.
Gap end_gap(const Facing& found, double end) {
  const Side &face = found.face, &other = found.other;  // the other side's tangent is opposite
  const Vec2 corner = face.middle + (end * face.half_length) * face.t;
  const Vec2 other_corner = other.middle - (end * other.half_length) * other.t;
  const bool other_is_nearer = end * dot(other_corner - corner, face.t - other.t) <= 0.0;
  const double depth =
      other_is_nearer ? -dot(other_corner - face.middle, face.n) : -dot(corner - other.middle, other.n);
  // Separate sides need not be opposite each other; then the depth of a corner below a side's line is meaningless.
  if (found.depth < 0.0) {
    const double gap = std::min(found.depth, depth);
    const bool corner_of_a = other_is_nearer == found.face_of_b;  // the contact point is in the middle of the gap
    const Vec2 to_middle = (corner_of_a ? -0.5 : 0.5) * gap * found.n_AB();
    return {gap, found.n_AB(), (other_is_nearer ? other_corner : corner) + to_middle};
  }
  if (other_is_nearer) return {depth, found.n_AB(), other_corner};
  return {depth, found.face_of_b ? other.n : -other.n, corner};
}

}  // namespace

Depth depth_below(const Terrain& shape, Vec2 p) {
  const std::vector<Vec2>& points = shape.points;
  Depth best;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 along = points[i + 1] - points[i];
    double part = dot(p - points[i], along) / dot(along, along);
    if (i > 0) part = std::max(part, 0.0);
    if (i + 2 < points.size()) part = std::min(part, 1.0);
    const Vec2 from = p - (points[i] + part * along);
    const double distance = norm(from);
    if (distance >= smallest) continue;
    smallest = distance;
    const Vec2 normal = (1.0 / norm(along)) * Vec2{-along.y, along.x};
    // Over a segment, the sign along its normal decides between above and below. At a corner both neighbouring segments
    // agree on this sign, except for points in the wedge behind one of them, where the corner itself decides.
    const bool corner = (part == 0.0 && i > 0) || (part == 1.0 && i + 2 < points.size());
    if (!corner || distance == 0.0) {
      const double height = dot(from, normal);
      best = {-height, normal};
      continue;
    }
    const std::size_t at = part == 0.0 ? i : i + 1;
    // The mean of both neighbouring normals points out of the ground wherever the corner is the nearest point.
    const Vec2 before = points[at] - points[at - 1], after = points[at + 1] - points[at];
    const Vec2 out = (1.0 / norm(before)) * Vec2{-before.y, before.x} + (1.0 / norm(after)) * Vec2{-after.y, after.x};
    const double side = dot(from, out) < 0.0 ? -1.0 : 1.0;
    best = {-side * distance, (side / distance) * from};
  }
  return best;
}

Depth depth_below(const Rectangle& shape, Vec2 p) {
  const double beyond_x = std::abs(p.x) - shape.half_width;
  const double beyond_y = std::abs(p.y) - shape.half_height;
  if (beyond_x > 0.0 && beyond_y > 0.0) {
    const Vec2 from_corner{sign(p.x) * beyond_x, sign(p.y) * beyond_y};
    const double distance = norm(from_corner);
    return {-distance, (1.0 / distance) * from_corner};
  }
  if (beyond_x >= beyond_y) return {-beyond_x, {sign(p.x), 0.0}};
  return {-beyond_y, {0.0, sign(p.y)}};
}

Gap gap(const Rectangle& a, const Pose& A, const Rectangle& b, const Pose& B) {
  const Facing found = facing(a, A, b, B);
  const Gap behind = end_gap(found, -1.0), ahead = end_gap(found, 1.0);
  const Vec2 deepest = behind.depth == ahead.depth  ? 0.5 * (behind.p_WC + ahead.p_WC)
                       : behind.depth > ahead.depth ? behind.p_WC
                                                    : ahead.p_WC;
  return {found.depth, found.n_AB(), deepest};
}

Gap gap(const RectangleEnd& a, const Pose& A, const Rectangle& b, const Pose& B) {
  const Facing found = facing(a.rectangle, A, b, B);
  // The face's tangent is 90 degrees counter-clockwise from its normal, which is n_AB or -n_AB.
  return end_gap(found, (a.end == 1) == found.face_of_b ? -1.0 : 1.0);
}

}  // namespace talus
