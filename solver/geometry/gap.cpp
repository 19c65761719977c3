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

/// A side of a rectangle in the world: outward normal, tangent, middle, half its length.
struct Side {
  Vec2 n;
  Vec2 t;
  Vec2 middle;
  double half_length;
};

Side side(const Rectangle& box, const Pose& pose, int i) {
  const bool upright = i % 2 == 0;  // sides 0 and 2 look along +-x, 1 and 3 along +-y
  const double s = i < 2 ? 1.0 : -1.0;
  const Vec2 n = pose.R_WB * (upright ? Vec2{s, 0.0} : Vec2{0.0, s});
  const double reach = upright ? box.half_width : box.half_height;
  return {n, {-n.y, n.x}, pose.p_WB + reach * n, upright ? box.half_height : box.half_width};
}

struct Overlap {
  double depth{std::numeric_limits<double>::infinity()};
  Side face{};
};

/// The side of the box below which the corners reach least deep.
Overlap least_overlap(const Rectangle& box, const Pose& pose, const std::array<Vec2, 4>& corners) {
  Overlap least;
  for (int i = 0; i < 4; ++i) {
    const Side face = side(box, pose, i);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec2 corner : corners)
      lowest = std::min(lowest, dot(corner - face.middle, face.n));
    if (-lowest < least.depth) least = {-lowest, face};
  }
  return least;
}

/// Deepest point below the face of the part of the other rectangle's outline that lies over the face's length: the side
/// that looks most against the face is cut to that length; flat sides give the middle of what is common.
Vec2 deepest_point(const Side& face, const Rectangle& box, const Pose& pose) {
  Side facing = side(box, pose, 0);
  for (int i = 1; i < 4; ++i) {
    const Side other = side(box, pose, i);
    if (dot(other.n, face.n) < dot(facing.n, face.n)) facing = other;
  }
  const Vec2 start = facing.middle - facing.half_length * facing.t;
  const Vec2 end = facing.middle + facing.half_length * facing.t;
  const double along_start = dot(start - face.middle, face.t);
  const double along_end = dot(end - face.middle, face.t);
  const auto cut = [&](double along) {
    const double wanted = std::clamp(along, -face.half_length, face.half_length);
    const double share = along_end == along_start ? 0.0 : (wanted - along_start) / (along_end - along_start);
    return start + std::clamp(share, 0.0, 1.0) * (end - start);
  };
  const Vec2 p = cut(along_start);
  const Vec2 q = cut(along_end);
  const double height_p = dot(p - face.middle, face.n);
  const double height_q = dot(q - face.middle, face.n);
  if (height_p == height_q) return 0.5 * (p + q);
  return height_p < height_q ? p : q;
}

}  // namespace

Depth depth_below(const Terrain& shape, Vec2 p) {
  const std::vector<Vec2>& points = shape.points;
  Depth best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 along = points[i + 1] - points[i];
    double part = dot(p - points[i], along) / dot(along, along);
    if (i > 0) part = std::max(part, 0.0);
    if (i + 2 < points.size()) part = std::min(part, 1.0);
    const Vec2 from = p - (points[i] + part * along);
    const double distance = norm(from);
    if (distance >= least) continue;
    least = distance;
    const Vec2 normal = (1.0 / norm(along)) * Vec2{-along.y, along.x};
    // Over a piece the sign of its normal tells the side. At a corner both pieces beside it agree on it, but for points
    // in the wedge behind one of them, where the corner itself decides.
    const bool corner = (part == 0.0 && i > 0) || (part == 1.0 && i + 2 < points.size());
    if (!corner || distance == 0.0) {
      const double height = dot(from, normal);
      best = {-height, normal};
      continue;
    }
    const std::size_t at = part == 0.0 ? i : i + 1;
    // The mean of the normals on both sides leads out of the ground wherever the corner is the nearest point.
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

Gap gap(const Rectangle& a, const Pose& A, const HalfPlane&, const Pose& B) {
  const Vec2 n = B.R_WB * Vec2{0.0, 1.0};
  double lowest = std::numeric_limits<double>::infinity();
  Vec2 sum;
  double count = 0.0;
  for (const Vec2 corner : world_corners(a, A)) {
    const double height = dot(corner - B.p_WB, n);
    if (height < lowest) {
      lowest = height;
      sum = corner;
      count = 1.0;
    } else if (height == lowest) {
      sum += corner;
      count += 1.0;
    }
  }
  return {-lowest, -n, (1.0 / count) * sum};
}

Gap gap(const Rectangle& a, const Pose& A, const Rectangle& b, const Pose& B) {
  const Overlap below_b = least_overlap(b, B, world_corners(a, A));
  const Overlap below_a = least_overlap(a, A, world_corners(b, B));
  if (below_b.depth <= below_a.depth) return {below_b.depth, -below_b.face.n, deepest_point(below_b.face, a, A)};
  return {below_a.depth, below_a.face.n, deepest_point(below_a.face, b, B)};
}

}  // namespace talus
