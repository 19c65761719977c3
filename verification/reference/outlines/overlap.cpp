#include "verification/reference/outlines/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace talus::verification::reference {
namespace {

/// Local frame of the outline, with its sine and cosine computed once.
class Frame {
 public:
  explicit Frame(const Outline& o) : x_{o.x}, y_{o.y}, c_{std::cos(o.angle)}, s_{std::sin(o.angle)} {}
  Point inwards(Point world) const {
    const double dx = world.x - x_, dy = world.y - y_;
    return {c_ * dx + s_ * dy, c_ * dy - s_ * dx};
  }
  Point outwards(Point own) const { return {x_ + c_ * own.x - s_ * own.y, y_ + s_ * own.x + c_ * own.y}; }

 private:
  double x_, y_, c_, s_;
};

/// Point of the boundary at the fraction 0 <= share < 1, in the outline's local frame.
Point boundary_point(const Outline& o, double fraction) {
  const double a = o.size.a, b = o.kind == OutlineKind::circle ? o.size.a : o.size.b;
  if (o.kind == OutlineKind::rectangle) {
    const double side = 4.0 * fraction, along = 2.0 * (side - std::floor(side)) - 1.0;
    const int i = static_cast<int>(side);
    const double sign = i < 2 ? 1.0 : -1.0;
    return i % 2 == 0 ? Point{sign * a, sign * along * b} : Point{-sign * along * a, sign * b};
  }
  const double t = 2.0 * std::numbers::pi * fraction, e = o.kind == OutlineKind::circle ? 1.0 : 2.0 / o.size.n;
  const double c = std::cos(t), s = std::sin(t);
  return {a * std::copysign(std::pow(std::abs(c), e), c), b * std::copysign(std::pow(std::abs(s), e), s)};
}

bool holds(const Outline& o, Point own) {
  switch (o.kind) {
    case OutlineKind::circle:
      return std::hypot(own.x, own.y) < o.size.a;
    case OutlineKind::rectangle:
      return std::abs(own.x) < o.size.a && std::abs(own.y) < o.size.b;
    case OutlineKind::superellipse: {
      const double u = std::abs(own.x) / o.size.a, v = std::abs(own.y) / o.size.b;
      return u < 1.0 && v < 1.0 && std::pow(u, o.size.n) + std::pow(v, o.size.n) < 1.0;
    }
    case OutlineKind::half_plane:
      return own.y < 0.0;
  }
  return false;
}

}  // namespace

bool contains(const Outline& outline, Point world) { return holds(outline, Frame{outline}.inwards(world)); }

std::vector<Point> boundary(const Outline& outline, int count) {
  std::vector<Point> points;
  if (outline.kind == OutlineKind::half_plane) return points;
  const Frame frame{outline};
  for (int i = 0; i < count; ++i)
    points.push_back(frame.outwards(boundary_point(outline, static_cast<double>(i) / count)));
  return points;
}

bool overlap_by_points(const Outline& a, const Outline& b, int count) {
  const auto any_in = [count](const Outline& of, const Outline& in) {
    const auto points = boundary(of, count);
    const Frame frame{in};
    return std::any_of(points.begin(), points.end(), [&](Point p) { return holds(in, frame.inwards(p)); });
  };
  return any_in(a, b) || any_in(b, a);
}

namespace {

/// Displacement of b in the direction of the angle after which it no longer overlaps a.
double displacement(const Outline& a, Outline b, double angle, int count) {
  const double c = std::cos(angle), s = std::sin(angle), x = b.x, y = b.y;
  const auto overlaps = [&](double by) {
    b.x = x + by * c, b.y = y + by * s;
    return overlap_by_points(a, b, count);
  };
  double inside = 0.0, outside = 2.0 * (a.size.a + a.size.b + b.size.a + b.size.b);
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (inside + outside);
    (overlaps(middle) ? inside : outside) = middle;
  }
  return 0.5 * (inside + outside);
}

/// Smallest distance of a corner of one polygon from the sides of the other.
double distance_from_sides(const std::vector<Point>& corners, const std::vector<Point>& polygon) {
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point from = polygon[i], to = polygon[(i + 1) % polygon.size()];
    const double dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
    for (const Point p : corners) {
      const double share = std::clamp(((p.x - from.x) * dx + (p.y - from.y) * dy) / square, 0.0, 1.0);
      minimum = std::min(minimum, std::hypot(from.x + share * dx - p.x, from.y + share * dy - p.y));
    }
  }
  return minimum;
}

double distance_of_polygons(const Outline& a, const Outline& b, int count) {
  const std::vector<Point> of_a = boundary(a, count), of_b = boundary(b, count);
  return std::min(distance_from_sides(of_a, of_b), distance_from_sides(of_b, of_a));
}

}  // namespace

double minimum_displacement(const Outline& a, const Outline& b, int count) {
  if (!overlap_by_points(a, b, count)) return -distance_of_polygons(a, b, count);
  constexpr int directions = 90;
  constexpr double part = 2.0 * std::numbers::pi / directions;
  double best = 0.0, minimum = std::numeric_limits<double>::infinity();
  for (int i = 0; i < directions; ++i) {
    const double found = displacement(a, b, i * part, count / 8);
    if (found < minimum) best = i * part, minimum = found;
  }
  constexpr double golden = 0.6180339887498949;
  double low = best - part, high = best + part;
  for (int i = 0; i < 16; ++i) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    if (displacement(a, b, left, count) < displacement(a, b, right, count)) {
      high = right;
    } else {
      low = left;
    }
  }
  return displacement(a, b, 0.5 * (low + high), count);
}

}  // namespace talus::verification::reference
