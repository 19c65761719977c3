#include "verification/reference/outlines/superellipse.hpp"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

BOOST_AUTO_TEST_SUITE(superellipse_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon(), pi = std::numbers::pi;

ref::Point on_outline(const ref::Superellipse& s, double t) {
  const double c = std::cos(t), d = std::sin(t);
  return {s.a * std::copysign(std::pow(std::abs(c), 2.0 / s.n), c),
          s.b * std::copysign(std::pow(std::abs(d), 2.0 / s.n), d)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(ellipse_and_near_rectangle) {
  const ref::Superellipse ellipse{1.25, 4.0, 2.0};
  BOOST_TEST(std::abs(ref::area(ellipse) / (pi * 5.0) - 1.0) < 2 * eps);
  BOOST_TEST(std::abs(ref::polar_moment(ellipse) / (pi / 4.0 * 5.0 * (1.5625 + 16.0)) - 1.0) < 2 * eps);
  const ref::Superellipse box{1.25, 4.0, 1e6};
  BOOST_TEST(ref::area(box) == 20.0, boost::test_tools::tolerance(1e-11));
  BOOST_TEST(ref::polar_moment(box) == 20.0 / 3.0 * (1.5625 + 16.0), boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(area_and_moment_by_quadrature) {
  boost::math::quadrature::tanh_sinh<double> rule;
  for (const double n : {2.5, 3.0, 8.0, 50.0}) {
    const ref::Superellipse s{1.25, 4.0, n};
    // A quarter, in u = x/a: height b (1 - u^n)^(1/n); near u = 1 computed from the distance to the end.
    const auto height = [&](double u, double to_end) {
      const double fraction = u > 0.5 ? -std::expm1(n * std::log1p(-std::abs(to_end))) : 1.0 - std::pow(u, n);
      return std::pow(fraction, 1.0 / n);
    };
    const double area = 4.0 * s.a * s.b * rule.integrate([&](double u, double e) { return height(u, e); }, 0.0, 1.0);
    const double moment = 4.0 * s.a * s.b *
                          rule.integrate(
                              [&](double u, double e) {
                                const double h = height(u, e);
                                return s.a * s.a * u * u * h + s.b * s.b * h * h * h / 3.0;
                              },
                              0.0, 1.0);
    BOOST_TEST(ref::area(s) == area, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(ref::polar_moment(s) == moment, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(polygons) {
  const std::vector<ref::Point> box{{1.0, 2.0}, {-1.0, 2.0}, {-1.0, -2.0}, {1.0, -2.0}};
  BOOST_TEST(ref::polygon_area(box) == 8.0);
  BOOST_TEST(ref::polygon_polar_moment(box) == 8.0 * (4.0 + 16.0) / 12.0, boost::test_tools::tolerance(2 * eps));
  // Area that a regular polygon lacks compared with a circle: pi - M/2 sin(2 pi/M) = 2 pi^3/(3 M^2).
  BOOST_TEST(ref::area_cut_off({1.0, 1.0, 2.0}, 100.0) == 2.0 * pi * pi * pi / 3e4,
             boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(support_is_the_largest_reach) {
  for (const double n : {2.0, 3.0, 8.0, 50.0}) {
    const ref::Superellipse s{1.25, 4.0, n};
    for (const double angle : {0.0, 0.3, 0.785, 1.2, 1.5, 2.5, 4.0}) {
      const double c = std::cos(angle), d = std::sin(angle);
      double reach = 0.0;
      for (int i = 0; i < 200000; ++i) {
        const ref::Point p = on_outline(s, 2.0 * pi * i / 200000.0);
        reach = std::max(reach, p.x * c + p.y * d);
      }
      BOOST_TEST(reach <= ref::support(s, c, d) * (1.0 + 4 * eps));
      BOOST_TEST(reach == ref::support(s, c, d), boost::test_tools::tolerance(1e-8));
    }
  }
}

BOOST_AUTO_TEST_CASE(curvature_of_the_corner_by_the_circle_through_three_points) {
  for (const double n : {2.0, 3.0, 8.0, 20.0}) {
    // 4 area/(product of the sides), with points slightly to either side of the corner.
    const double d = 1e-3 / n;
    const ref::Point p = on_outline({1.5, 1.5, n}, pi / 4 - d), q = on_outline({1.5, 1.5, n}, pi / 4),
                     r = on_outline({1.5, 1.5, n}, pi / 4 + d);
    const double twice = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    const double sides =
        std::hypot(q.x - p.x, q.y - p.y) * std::hypot(r.x - q.x, r.y - q.y) * std::hypot(r.x - p.x, r.y - p.y);
    BOOST_TEST(2.0 * twice / sides == ref::corner_curvature(1.5, n), boost::test_tools::tolerance(1e-4));
  }
  BOOST_TEST(ref::corner_curvature(1.0, 20.0) == 13.91, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(excess_is_zero_on_the_outline) {
  for (const double n : {2.0, 8.0, 50.0}) {
    const ref::Superellipse s{1.25, 4.0, n};
    for (int i = 0; i < 64; ++i)
      BOOST_TEST(std::abs(ref::excess(s, on_outline(s, 0.1 * i))) < 4 * n * eps);
  }
}

BOOST_AUTO_TEST_CASE(nearest_point_of_circles_and_along_normals) {
  const ref::Superellipse circle{1.5, 1.5, 2.0};
  for (const ref::Point p : {ref::Point{0.3, 0.4}, {-2.0, 1.0}, {0.0, 3.0}, {1.0, -1.0}})
    BOOST_TEST(std::abs(ref::nearest_point(circle, p).distance - std::abs(1.5 - std::hypot(p.x, p.y))) < 4 * eps);
  // A point outside on the normal through a point of an outline has that point as its nearest, whatever n.
  for (const double n : {2.0, 3.0, 8.0, 50.0}) {
    const ref::Superellipse s{1.25, 4.0, n};
    for (const double t : {0.2, 0.7, 1.1, 2.0, 4.0}) {
      const ref::Point q = on_outline(s, t);
      const double gx = std::copysign(std::pow(std::abs(q.x) / s.a, n - 1.0) / s.a, q.x);
      const double gy = std::copysign(std::pow(std::abs(q.y) / s.b, n - 1.0) / s.b, q.y);
      const double g = std::hypot(gx, gy);
      const ref::NearestPoint found = ref::nearest_point(s, {q.x + 0.3 * gx / g, q.y + 0.3 * gy / g});
      BOOST_TEST(found.distance == 0.3, boost::test_tools::tolerance(1e-13));
      BOOST_TEST(std::hypot(found.p.x - q.x, found.p.y - q.y) < 1e-6);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
