/// The nearest point of a superquadric's outline, and its gap to a half-plane.

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/geometry/gap.hpp"

namespace talus {
namespace {

/// One arc of the outline in the first quadrant, from an axis to the corner where both terms are 1/2. Its coordinate is
/// y = b eta, which is well conditioned on the flat side, unlike the parametric angle:
///   X(eta) = (a (1 - eta^n)^(1/n), b eta),   0 <= eta <= 2^(-1/n)
struct Arc {
  double a;
  double b;
  double n;

  /// A position on the arc: x/a, y/b, and the term eta^n.
  struct Point {
    double xi;
    double eta;
    double term;
  };
  Point at(double eta) const { return at(eta, power(eta, n)); }
  Point at(double eta, double term) const { return {power(1.0 - term, 1.0 / n), eta, term}; }

  Vec2 point(const Point& at) const { return {a * at.xi, b * at.eta}; }
  /// Outward normal at a position, not normalised: the gradient divided by n.
  Vec2 normal(const Point& at) const {
    return {(1.0 - at.term) / (at.xi * a), at.eta == 0.0 ? 0.0 : at.term / (at.eta * b)};
  }
  /// Half the derivative of |X - p|^2 along the arc, times a positive factor: cross product of the normal and X - p.
  double slope(const Point& at, Vec2 p) const { return cross(normal(at), point(at) - p); }
};

struct Nearest {
  double distance{std::numeric_limits<double>::infinity()};
  Vec2 normal;
};

void consider(const Arc& arc, const Arc::Point& at, Vec2 p, bool swapped, Nearest& best) {
  const double distance = norm(arc.point(at) - p);
  if (distance >= best.distance) return;
  const Vec2 n = arc.normal(at);
  const Vec2 unit = (1.0 / norm(n)) * n;
  best = {distance, swapped ? Vec2{unit.y, unit.x} : unit};
}

/// The point of the arc nearest to p. A point deep inside may have several local minima, so that the arc is searched
/// interval by interval. For high exponents the normal turns almost only near the corner, where the terms are not
/// small: half of the intervals divide the flat side evenly, the others approach the corner with the term growing by
/// sqrt(2).
class Search {
 public:
  Search(const Arc& arc, Vec2 p, bool swapped, Nearest& best) : arc_{arc}, p_{p}, swapped_{swapped}, best_{best} {}

  void run() {
    constexpr int even = 8, graded = 16;
    const double ratio = power(0.5, 0.5 / arc_.n);
    std::array<double, graded + 1> towards_corner{};  // eta with the terms 1/2, 1/2/sqrt(2), ...
    towards_corner[0] = ratio * ratio;
    for (std::size_t i = 0; i < graded; ++i)
      towards_corner[i + 1] = towards_corner[i] * ratio;
    left_ = arc_.at(0.0, 0.0);
    slope_left_ = arc_.slope(left_, p_);
    consider(arc_, left_, p_, swapped_, best_);
    for (int i = 1; i <= even; ++i)
      look_up_to(arc_.at(towards_corner.back() * i / even));
    for (std::size_t i = graded; i-- > 0;)
      look_up_to(arc_.at(towards_corner[i]));
    consider(arc_, left_, p_, swapped_, best_);
  }

 private:
  /// Searches the interval that begins where the previous one ended.
  void look_up_to(const Arc::Point& right) {
    const double slope_right = arc_.slope(right, p_);
    if (slope_left_ < 0.0 && slope_right > 0.0) {
      std::uintmax_t evaluations = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
          [this](double eta) { return arc_.slope(arc_.at(eta), p_); }, left_.eta, right.eta, slope_left_, slope_right,
          boost::math::tools::eps_tolerance<double>(52), evaluations);
      consider(arc_, arc_.at(0.5 * (low + high)), p_, swapped_, best_);
    }
    left_ = right;
    slope_left_ = slope_right;
  }

  const Arc& arc_;
  Vec2 p_;
  bool swapped_;
  Nearest& best_;
  Arc::Point left_{};
  double slope_left_{};
};

}  // namespace

Depth depth_below(const Superquadric& shape, Vec2 p) {
  const Vec2 folded{std::abs(p.x), std::abs(p.y)};
  Nearest best;
  const Arc beside{shape.half_width, shape.half_height, shape.exponent};
  const Arc above{shape.half_height, shape.half_width, shape.exponent};
  Search{beside, folded, false, best}.run();
  Search{above, {folded.y, folded.x}, true, best}.run();
  const Vec2 normal{std::copysign(best.normal.x, p.x), std::copysign(best.normal.y, p.y)};
  return {is_inside(shape, p) ? best.distance : -best.distance, normal};
}

// The lowest point is where the outward normal is -n_B.
Gap gap(const Superquadric& a, const Pose& A, const HalfPlane&, const Pose& B) {
  const Vec2 n = B.R_WB * Vec2{0.0, 1.0};
  const Vec2 lowest = world_point(A, farthest_point(a, unrotate(A.R_WB, -n)));
  const double depth = -dot(lowest - B.p_WB, n);
  return {depth, -n, lowest + (0.5 * depth) * n};
}

}  // namespace talus
