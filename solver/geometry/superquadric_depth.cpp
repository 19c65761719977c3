/// The nearest point of a superquadric's outline, and how it stands to a half-plane.

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/geometry/gap.hpp"

namespace talus {
namespace {

/// One arc of the outline in the first quadrant, from an axis to the corner where both terms are 1/2. Along it the
/// coordinate y = b eta runs, which unlike the parametric angle is well conditioned on the flat side:
///   X(eta) = (a (1 - eta^n)^(1/n), b eta),   0 <= eta <= 2^(-1/n)
struct Arc {
  double a;
  double b;
  double n;

  Vec2 point(double eta) const { return {a * power(1.0 - power(eta, n), 1.0 / n), b * eta}; }
  /// Outward normal there, not of unit length: the gradient, divided by n.
  Vec2 normal(double eta) const {
    const double u = power(1.0 - power(eta, n), 1.0 / n);
    return {power(u, n - 1.0) / a, power(eta, n - 1.0) / b};
  }
  /// Half the derivative of |X - p|^2 along the arc, scaled by a positive factor: cross product of normal and X - p.
  double slope(double eta, Vec2 p) const { return cross(normal(eta), point(eta) - p); }
};

struct Nearest {
  double distance{std::numeric_limits<double>::infinity()};
  Vec2 normal;
};

void consider(const Arc& arc, double eta, Vec2 p, bool swapped, Nearest& best) {
  const double distance = norm(arc.point(eta) - p);
  if (distance >= best.distance) return;
  const Vec2 n = arc.normal(eta);
  const Vec2 unit = (1.0 / norm(n)) * n;
  best = {distance, swapped ? Vec2{unit.y, unit.x} : unit};
}

/// The point of the arc nearest to p: a point deep inside may have several that are locally nearest, so the arc is
/// searched piece by piece.
void search(const Arc& arc, Vec2 p, bool swapped, Nearest& best) {
  constexpr int pieces = 16;
  const double end = power(0.5, 1.0 / arc.n);
  double left = 0.0;
  double slope_left = arc.slope(left, p);
  consider(arc, left, p, swapped, best);
  for (int i = 1; i <= pieces; ++i) {
    const double right = end * i / pieces;
    const double slope_right = arc.slope(right, p);
    if (slope_left < 0.0 && slope_right > 0.0) {
      std::uintmax_t evaluations = 100;
      const auto [low, high] =
          boost::math::tools::toms748_solve([&](double eta) { return arc.slope(eta, p); }, left, right, slope_left,
                                            slope_right, boost::math::tools::eps_tolerance<double>(52), evaluations);
      consider(arc, 0.5 * (low + high), p, swapped, best);
    }
    left = right;
    slope_left = slope_right;
  }
  consider(arc, end, p, swapped, best);
}

}  // namespace

Depth depth_below(const Superquadric& shape, Vec2 p) {
  const Vec2 folded{std::abs(p.x), std::abs(p.y)};
  Nearest best;
  search({shape.half_width, shape.half_height, shape.exponent}, folded, false, best);
  search({shape.half_height, shape.half_width, shape.exponent}, {folded.y, folded.x}, true, best);
  const Vec2 normal{std::copysign(best.normal.x, p.x), std::copysign(best.normal.y, p.y)};
  return {is_inside(shape, p) ? best.distance : -best.distance, normal};
}

// The lowest point is where the outward normal is m = -n_B. By Hoelder's inequality the support function is the dual
// norm h = (|a m_x|^q + |b m_y|^q)^(1/q), q = n/(n - 1), reached at x = a |a m_x/h|^(q - 1), y alike.
Gap gap(const Superquadric& a, const Pose& A, const HalfPlane&, const Pose& B) {
  const Vec2 n = B.R_WB * Vec2{0.0, 1.0};
  const Vec2 m = unrotate(A.R_WB, -n);
  const double q = a.exponent / (a.exponent - 1.0);
  const double h = gauge({1.0 / a.half_width, 1.0 / a.half_height, q}, m);
  const double x = a.half_width * power(a.half_width * std::abs(m.x) / h, q - 1.0);
  const double y = a.half_height * power(a.half_height * std::abs(m.y) / h, q - 1.0);
  const Vec2 lowest = world_point(A, {std::copysign(x, m.x), std::copysign(y, m.y)});
  const double depth = -dot(lowest - B.p_WB, n);
  return {depth, -n, lowest + (0.5 * depth) * n};
}

}  // namespace talus
