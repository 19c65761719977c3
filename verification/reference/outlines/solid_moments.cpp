#include "verification/reference/outlines/solid_moments.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <utility>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {

SolidMoments integrated_moments(Solid solid, double a, double b) {
  const Real50 half_width{a}, half_height{b}, pi = boost::math::constants::pi<Real50>();
  const auto slice = [&](const Real50& y, Real50& area, Real50& second) {
    if (solid == Solid::block) {
      area = 4 * half_width * half_width;
      second = area * half_width * half_width / 3;
      return;
    }
    const Real50 shrink = solid == Solid::ellipsoid ? 1 - y * y / (half_height * half_height) : Real50{1};
    const Real50 across = solid == Solid::ellipsoid ? Real50{std::min(a, b)} : half_width;
    area = pi * half_width * across * shrink;
    second = area * half_width * half_width * shrink / 4;
  };
  // Three-point Gauss quadrature, exact up to degree 5; the slices are of degree 4 at most.
  const Real50 at = half_height * sqrt(Real50{3} / 5);
  Real50 volume{0}, polar{0};
  for (const auto& [y, weight] : {std::pair{Real50{0}, 8}, std::pair{at, 5}, std::pair{Real50{-at}, 5}}) {
    Real50 area, second;
    slice(y, area, second);
    volume += weight * area;
    polar += weight * (second + y * y * area);
  }
  return {nearest(volume * half_height / 9), nearest(polar * half_height / 9)};
}

Point polygon_centroid(const std::vector<Point>& corners) {
  Point sum;
  double twice_area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point p = corners[i], q = corners[(i + 1) % corners.size()];
    const double twice = p.x * q.y - p.y * q.x;
    twice_area += twice;
    sum = {sum.x + (p.x + q.x) * twice, sum.y + (p.y + q.y) * twice};
  }
  return {sum.x / (3.0 * twice_area), sum.y / (3.0 * twice_area)};
}

}  // namespace talus::verification::reference
