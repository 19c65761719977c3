#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/base/vec.hpp"

namespace talus {

/// The outline |x/a|^n + |y/b|^n = 1 about the body's centre of mass (Barr 1981; Mustoe & Huttelmaier 1993, Eq. 1): an
/// ellipse for n = 2, approaching a rectangle as n grows.
struct Superquadric {
  static constexpr std::string_view name = "superquadric";
  double half_width{};   ///< a, along the body's x axis [L] > 0
  double half_height{};  ///< b, along the body's y axis [L] > 0
  double exponent{2.0};  ///< n >= 1: for smaller n the outline is not convex

  static constexpr std::array<Field<Superquadric>, 3> fields() {
    return {
        {{"half_width", dimension::length, &Superquadric::half_width, Range::positive, "half its size along x"},
         {"half_height", dimension::length, &Superquadric::half_height, Range::positive, "half its size along y"},
         {"exponent", dimension::number, &Superquadric::exponent, Range::positive, "n > 1 of |x/a|^n + |y/b|^n = 1"}}};
  }
  friend constexpr bool operator==(const Superquadric&, const Superquadric&) = default;
};

/// The gauge (|x/a|^n + |y/b|^n)^(1/n): below 1 inside, 1 on the outline, above 1 outside; p/gauge lies on the outline.
[[nodiscard]] double gauge(const Superquadric& shape, Vec2 p);

/// Whether a point lies inside: compares the gauge with 1 without evaluating its root.
[[nodiscard]] bool is_inside(const Superquadric& shape, Vec2 p);

/// base^exponent for base >= 0, bit-identical on every machine.
[[nodiscard]] double power(double base, double exponent);

/// x^(1/degree) for 1 <= x <= 2, bit-identical on every machine: error at most 1.5 units in the last place, and exactly
/// 1 for x = 1. Integer degrees take less than half the time of power().
[[nodiscard]] double root(double x, double degree);

/// Outward unit normal at a point of the outline, in the shape's axes.
[[nodiscard]] Vec2 outward_normal(const Superquadric& shape, Vec2 p);

/// The point of the outline farthest along a direction m, in the shape's axes; exact for every exponent > 1.
[[nodiscard]] Vec2 farthest_point(const Superquadric& shape, Vec2 m);

/// Curvature at a point of the outline [1/L]: 1/r for a circle, zero in the middle of a side for n > 2.
[[nodiscard]] double curvature(const Superquadric& shape, Vec2 p);

/// Point of the outline at the parametric angle t [rad]: (a sgn(cos t) |cos t|^(2/n), b sgn(sin t) |sin t|^(2/n)).
[[nodiscard]] Vec2 boundary_point(const Superquadric& shape, double t);

}  // namespace talus
