#pragma once

#include <vector>

#include "verification/reference/outlines/superellipse.hpp"

/// Volume and moments of solids and areas by integration, to check closed forms.
namespace talus::verification::reference {

/// Solids that extend across the plane of motion, with half-lengths a, b in the plane.
enum class Solid {
  ellipsoid,  ///< half-length min(a, b) across the plane
  block,      ///< half-length a across the plane
  cylinder,   ///< upright: radius a, height 2 b
};

struct SolidMoments {
  double volume{};  ///< [L^3]
  double polar{};   ///< integral of x^2 + y^2 [L^5]
};

/// Integration over slices at height y: each has an area A(y) and a second moment of x, S(y), and
///   volume = integral of A dy,   polar = integral of S + y^2 A dy,
/// at 50 digits (by three-point Gauss quadrature, exact for these slices).
/// Slices: ellipse of half-lengths a s, c s, s = sqrt(1 - y^2/b^2) (A = pi a c s^2, S = A (a s)^2/4); square 2 a x 2 a
/// (S = A a^2/3); circle of radius a (S = A a^2/4).
[[nodiscard]] SolidMoments integrated_moments(Solid solid, double a, double b);

/// Centroid of a closed polygon, counter-clockwise: (1/6A) sum (p_i + p_{i+1})(p_i x p_{i+1}).
[[nodiscard]] Point polygon_centroid(const std::vector<Point>& corners);

}  // namespace talus::verification::reference
