#pragma once

#include <vector>

#include "verification/reference/superellipse.hpp"

/// Volume and moments of solids and areas by integration: what closed forms are tried against.
namespace talus::verification::reference {

/// Solids that stand across the plane of motion, of half-lengths a, b in it.
enum class Solid {
  ellipsoid,  ///< half-length min(a, b) across the plane
  block,      ///< half-length a across it
  cylinder,   ///< upright: radius a, height 2 b
};

struct SolidMoments {
  double volume{};  ///< [L^3]
  double polar{};   ///< integral of x^2 + y^2 [L^5]
};

/// By slices at height y: each has an area A(y) and a second moment of x, S(y), and
///   volume = integral of A dy,   polar = integral of S + y^2 A dy,   at 50 digits (by Gauss's three
/// points, exact for these slices).
/// Slices: ellipse of half-lengths a s, c s, s = sqrt(1 - y^2/b^2) (A = pi a c s^2, S = A (a s)^2/4); square 2 a x 2 a
/// (S = A a^2/3); circle of radius a (S = A a^2/4).
[[nodiscard]] SolidMoments integrated_moments(Solid solid, double a, double b);

/// Centroid of a closed polygon, counter-clockwise: (1/6A) sum (p_i + p_{i+1})(p_i x p_{i+1}).
[[nodiscard]] Point polygon_centroid(const std::vector<Point>& corners);

}  // namespace talus::verification::reference
