/// The gap between two convex outlines, by their support functions.

#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/geometry/gap.hpp"

namespace talus {
namespace {

Vec2 quarter_turn(Vec2 v) { return {-v.y, v.x}; }

/// The farthest point of an outline in the direction m (body axes). For a rectangle it is a corner; for m along a
/// rectangle axis, the corner of the quadrant that `within` points into.
Vec2 farthest(const Rectangle& s, Vec2, Vec2 within) {
  return {std::copysign(s.half_width, within.x), std::copysign(s.half_height, within.y)};
}
Vec2 farthest(const Superquadric& s, Vec2 m, Vec2) { return farthest_point(s, m); }

/// Curvature of an outline at its farthest point [1/L]; for a rectangle zero along a side normal, else infinite.
double bend(const Superquadric& s, Vec2 p, bool) { return curvature(s, p); }
double bend(const Rectangle&, Vec2, bool side) { return side ? 0.0 : std::numeric_limits<double>::infinity(); }

/// Overlap of two outlines along the direction n from A to B: f(n) = n . (p - q), with p the point of A farthest along
/// n and q the point of B farthest against n. When n turns counter-clockwise, f changes at the rate f' = t . (p - q),
/// where t is n turned by 90 degrees.
template <class S, class T>
class Common {
 public:
  Common(const S& a, const Pose& A, const T& b, const Pose& B) : a_{a}, A_{A}, b_{b}, B_{B} {}

  struct At {
    Vec2 n;
    Vec2 p;  ///< point of A
    Vec2 q;  ///< point of B
    double value{};
    double slope{};
    bool side_of_a{};  ///< n is the normal of a side of A
  };
  /// Value in the direction of v; `within` is a direction between the same two neighbouring side normals.
  At at(Vec2 v, Vec2 within) const {
    const Vec2 n = (1.0 / norm(v)) * v;
    const Vec2 p = world_point(A_, farthest(a_, unrotate(A_.R_WB, n), unrotate(A_.R_WB, within)));
    const Vec2 q = world_point(B_, farthest(b_, unrotate(B_.R_WB, -n), unrotate(B_.R_WB, -within)));
    return {n, p, q, dot(n, p - q), dot(quarter_turn(n), p - q), false};
  }
  /// Point of action of the force, half-way through the overlap. On the flat part of a side the farthest point is
  /// ill-conditioned in the direction (it varies with the power 1/(n - 1) of the angle); the point of the outline with
  /// the larger curvature is used.
  Vec2 contact_point(const At& at) const {
    const double of_a = bend(a_, unrotate(A_.R_WB, at.p - A_.p_WB), at.side_of_a);
    const double of_b = bend(b_, unrotate(B_.R_WB, at.q - B_.p_WB), false);
    const Vec2 half = (0.5 * at.value) * at.n;
    return of_a > of_b ? at.p - half : at.q + half;
  }

 private:
  const S& a_;
  const Pose& A_;
  const T& b_;
  const Pose& B_;
};

/// Side normals of both outlines, alternating, A's first, counter-clockwise. Between two neighbouring normals the
/// farthest point of a rectangle is one corner, and that of a superquadric moves along one arc.
std::array<Vec2, 9> side_normals(const Pose& A, const Pose& B) {
  const Vec2 x = A.R_WB * Vec2{1.0, 0.0};
  Vec2 other = B.R_WB * Vec2{1.0, 0.0};
  while (!(dot(other, x) > 0.0 && cross(x, other) >= 0.0))
    other = quarter_turn(other);
  std::array<Vec2, 9> normals;
  Vec2 of_a = x;
  for (std::size_t i = 0; i < 8; i += 2) {
    normals[i] = of_a, normals[i + 1] = other;
    of_a = quarter_turn(of_a), other = quarter_turn(other);
  }
  normals[8] = normals[0];
  return normals;
}

/// The minimum of f over all directions. f plus its second derivative is the sum of both radii of curvature, so that f
/// is convex where f < 0: separate outlines have a single minimum, downhill from any such direction. Overlapping
/// outlines can have one minimum at each side and corner: there the arcs between side normals are searched in several
/// intervals.
template <class S, class T>
class CommonMinimum {
 public:
  using Function = Common<S, T>;
  using At = typename Function::At;

  CommonMinimum(const S& a, const Pose& A, const T& b, const Pose& B) : f_{a, A, b, B}, normals_{side_normals(A, B)} {}

  At find() {
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const At found = f_.at(normals_[i], middle(i));
      if (found.value < best_.value) best_ = found, best_.side_of_a = i % 2 == 0, lowest = i;
    }
    if (best_.value < 0.0) {
      search_arc(lowest, 1);
      search_arc((lowest + 7) % 8, 1);
    } else {
      for (std::size_t i = 0; i < 8; ++i)
        search_arc(i, 4);
    }
    return best_;
  }

  const Function& function() const { return f_; }

 private:
  Vec2 middle(std::size_t arc) const { return normals_[arc] + normals_[arc + 1]; }

  /// Searches between two neighbouring normals, in `parts` intervals, for points where the slope rises through zero.
  void search_arc(std::size_t arc, int parts) {
    const Vec2 from = normals_[arc], to = normals_[arc + 1], within = middle(arc);
    if (!(cross(from, to) > 0.0)) return;
    const auto at = [&](double s) { return f_.at((1.0 - s) * from + s * to, within); };
    double left = 0.0, slope_left = at(left).slope;
    for (int i = 1; i <= parts; ++i) {
      const double right = static_cast<double>(i) / parts, slope_right = at(right).slope;
      if (slope_left < 0.0 && slope_right > 0.0) {
        std::uintmax_t evaluations = 100;
        const auto [low, high] =
            boost::math::tools::toms748_solve([&](double s) { return at(s).slope; }, left, right, slope_left,
                                              slope_right, boost::math::tools::eps_tolerance<double>(52), evaluations);
        const At found = at(0.5 * (low + high));
        if (found.value < best_.value) best_ = found;
      }
      left = right, slope_left = slope_right;
    }
  }

  Function f_;
  std::array<Vec2, 9> normals_;
  At best_{{}, {}, {}, std::numeric_limits<double>::infinity(), 0.0, false};
};

template <class S, class T>
Gap convex_gap(const S& a, const Pose& A, const T& b, const Pose& B) {
  CommonMinimum<S, T> common{a, A, b, B};
  const auto found = common.find();
  return {found.value, found.n, common.function().contact_point(found)};
}

}  // namespace

Gap gap(const Superquadric& a, const Pose& A, const Superquadric& b, const Pose& B) { return convex_gap(a, A, b, B); }

Gap gap(const Rectangle& a, const Pose& A, const Superquadric& b, const Pose& B) { return convex_gap(a, A, b, B); }

}  // namespace talus
