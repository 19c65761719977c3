/// The gap between two convex outlines by their support functions.

#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/geometry/gap.hpp"

namespace talus {
namespace {

Vec2 quarter_turn(Vec2 v) { return {-v.y, v.x}; }

/// The farthest point of an outline in the direction m (body axes). Of a rectangle a corner; along its axes that of
/// the quadrant which `within` points into.
Vec2 farthest(const Rectangle& s, Vec2, Vec2 within) {
  return {std::copysign(s.half_width, within.x), std::copysign(s.half_height, within.y)};
}
Vec2 farthest(const Superquadric& s, Vec2 m, Vec2) { return farthest_point(s, m); }

/// How much an outline bends at its farthest point [1/L]; a rectangle along the normal of a side not at all.
double bend(const Superquadric& s, Vec2 p, bool) { return curvature(s, p); }
double bend(const Rectangle&, Vec2, bool side) { return side ? 0.0 : std::numeric_limits<double>::infinity(); }

/// What two outlines have in common in the direction n from A to B: f(n) = n . (p - q), with p the point of A farthest
/// along n and q that of B farthest against it. Turned counter-clockwise, f changes by f' = t . (p - q), t a quarter
/// turn from n.
template <class S, class T>
class Common {
 public:
  Common(const S& a, const Pose& A, const T& b, const Pose& B) : a_{a}, A_{A}, b_{b}, B_{B} {}

  struct At {
    Vec2 n;
    Vec2 p;  ///< of A
    Vec2 q;  ///< of B
    double value{};
    double slope{};
    bool side_of_a{};  ///< n is the normal of a side of A
  };
  /// In the direction of v; `within`: a direction between the same two neighbouring side normals.
  At at(Vec2 v, Vec2 within) const {
    const Vec2 n = (1.0 / norm(v)) * v;
    const Vec2 p = world_point(A_, farthest(a_, unrotate(A_.R_WB, n), unrotate(A_.R_WB, within)));
    const Vec2 q = world_point(B_, farthest(b_, unrotate(B_.R_WB, -n), unrotate(B_.R_WB, -within)));
    return {n, p, q, dot(n, p - q), dot(quarter_turn(n), p - q), false};
  }
  /// Where the force acts, half-way through the overlap. On the flat part of a side the direction does not tell the
  /// farthest point (it goes with the power 1/(n - 1) of the angle): the outline that bends more there does.
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

/// Normals of the sides of both outlines by turns, A's first, counter-clockwise. Between two neighbours a rectangle's
/// farthest point is one corner, and a superquadric's runs along one arc.
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

/// The least of f over all directions. Where f < 0, f plus its second derivative, the sum of both radii of curvature,
/// makes f convex: outlines apart have one least, downhill from any such direction. Outlines that overlap can have one
/// by each side and corner: the arcs between side normals are searched in parts.
template <class S, class T>
class LeastCommon {
 public:
  using Function = Common<S, T>;
  using At = typename Function::At;

  LeastCommon(const S& a, const Pose& A, const T& b, const Pose& B) : f_{a, A, b, B}, normals_{side_normals(A, B)} {}

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

  /// Between two neighbouring normals, in `parts` parts: where the slope rises through zero.
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
  LeastCommon<S, T> common{a, A, b, B};
  const auto found = common.find();
  return {found.value, found.n, common.function().contact_point(found)};
}

}  // namespace

Gap gap(const Superquadric& a, const Pose& A, const Superquadric& b, const Pose& B) { return convex_gap(a, A, b, B); }

Gap gap(const Rectangle& a, const Pose& A, const Superquadric& b, const Pose& B) { return convex_gap(a, A, b, B); }

}  // namespace talus
