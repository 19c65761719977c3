/// Superquadrics, the node depths of 1993, mass properties, and the rotation on which they depend.
#include "solver/geometry/superquadric.hpp"

#include <sleef.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "solver/geometry/mass_properties.hpp"
#include "solver/geometry/node_depth.hpp"

BOOST_AUTO_TEST_SUITE(superquadric_tests)

using namespace talus;

namespace {

constexpr double pi = std::numbers::pi;

Superquadric outline(double n) { return {1.25, 4.0, n}; }

/// Distance to the outline by brute force: each face sampled along its own direction, the point mirrored into the first
/// quadrant.
double brute_distance(const Superquadric& shape, Vec2 p) {
  const Vec2 folded{std::abs(p.x), std::abs(p.y)};
  const double a = shape.half_width, b = shape.half_height, n = shape.exponent;
  double best = std::numeric_limits<double>::infinity();
  constexpr int count = 100000;
  for (int i = 0; i <= count; ++i) {
    const double along = static_cast<double>(i) / count;
    const double across = std::pow(1.0 - std::pow(along, n), 1.0 / n);
    best = std::min({best, norm(Vec2{a * across, b * along} - folded), norm(Vec2{a * along, b * across} - folded)});
  }
  return best;
}

}  // namespace

BOOST_AUTO_TEST_CASE(roots_are_within_a_unit_and_a_half_of_the_last_place) {
  for (const double degree : {1.5, 2.0, 2.2, 3.0, 4.0, 5.0, 7.0, 10.0, 20.0, 33.0, 63.0, 64.0, 100.0}) {
    BOOST_TEST(root(1.0, degree) == 1.0);
    double worst = 0.0;
    for (int i = 1; i <= 20000; ++i) {
      const double x = 1.0 + i / 20000.0;
      const long double exact = std::pow(static_cast<long double>(x), 1.0L / static_cast<long double>(degree));
      worst = std::max(worst, static_cast<double>(std::abs(static_cast<long double>(root(x, degree)) - exact)));
    }
    BOOST_TEST(worst < 1.5 * std::numeric_limits<double>::epsilon(), "degree " << degree << ": " << worst);
  }
}

BOOST_AUTO_TEST_CASE(rotation_is_within_a_unit_of_the_last_place) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> angles{-0.785, 0.785};
  for (int i = 0; i < 200000; ++i) {
    const double angle = angles(random) * (i % 2 == 0 ? 1.0 : 1e-4);
    const Rotation r = rotation(angle);
    const long double sine = std::sin(static_cast<long double>(angle)),
                      cosine = std::cos(static_cast<long double>(angle));
    const double unit = std::nextafter(std::abs(r.sine), 2.0) - std::abs(r.sine);
    BOOST_REQUIRE(std::abs(static_cast<double>(r.sine - sine)) <= unit);
    BOOST_REQUIRE(std::abs(static_cast<double>(r.cosine - cosine)) <= 0x1p-53);
  }
  BOOST_TEST(rotation(-0.3).sine == -rotation(0.3).sine);
  // Beyond an eighth of a turn, near multiples of a quarter turn (where the result is small), and for large angles.
  std::uniform_real_distribution<double> turns{-60.0, 60.0}, far{-2e5, 2e5}, small{-1e-6, 1e-6};
  for (int i = 0; i < 300000; ++i) {
    const double angle = i % 3 == 0   ? turns(random)
                         : i % 3 == 1 ? std::round(turns(random)) * 0.5 * pi + small(random)
                                      : far(random);
    const Rotation r = rotation(angle);
    const long double x = angle;
    const auto units = [](double found, long double exact) {
      const double unit = std::nextafter(std::abs(found), 2.0) - std::abs(found);
      return std::abs(static_cast<double>(found - exact)) / unit;
    };
    BOOST_REQUIRE(units(r.sine, std::sin(x)) <= 1.2);
    BOOST_REQUIRE(units(r.cosine, std::cos(x)) <= 1.2);
  }
  BOOST_TEST(rotation(0.0).cosine == 1.0);
}

BOOST_AUTO_TEST_CASE(gauge_is_one_on_the_outline) {
  for (const double n : {2.0, 3.5, 8.0, 20.0, 50.0}) {
    for (int i = 0; i < 100; ++i) {
      const Vec2 p = boundary_point(outline(n), 0.01 + 2.0 * pi * i / 100);
      BOOST_TEST(gauge(outline(n), p) == 1.0, boost::test_tools::tolerance(1e-14));
      BOOST_TEST(is_inside(outline(n), 0.999 * p));
      BOOST_TEST(!is_inside(outline(n), 1.001 * p));
    }
  }
  BOOST_TEST(gauge({1.0, 1.0, 1000.0}, {1e300, 1.0}) == 1e300);  // no overflow far away
}

BOOST_AUTO_TEST_CASE(nodes_of_1993) {
  // Four nodes at the parametric 45 degrees: (a, b) 2^(-1/20), in FENCE's columns (1.2074, 3.8637).
  const auto nodes = boundary_nodes(outline(20.0), 4);
  BOOST_TEST(nodes.size() == 4u);
  BOOST_TEST(nodes[0].x == 1.25 * std::pow(2.0, -0.05), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(nodes[0].y == 4.0 * std::pow(2.0, -0.05), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(nodes[2].x == -nodes[0].x, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(nearest_depth_agrees_with_brute_force) {
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> x{-2.5, 2.5}, y{-6.0, 6.0};
  for (const double n : {2.0, 4.0, 20.0}) {
    for (int i = 0; i < 12; ++i) {
      const Vec2 p{x(random), y(random)};
      const Depth found = depth_below(outline(n), p);
      const double sign = is_inside(outline(n), p) ? 1.0 : -1.0;
      // A nearest sample that is half a grid step of 4e-5 away, at a distance d, causes an error of (2e-5)^2/(2 d),
      // with d 0.05 or more for all but points that are too near to matter.
      BOOST_TEST(std::abs(found.depth - sign * brute_distance(outline(n), p)) < 1e-8);
      BOOST_TEST(norm(found.normal) == 1.0, boost::test_tools::tolerance(1e-14));
    }
  }
}

BOOST_AUTO_TEST_CASE(ellipse_touches_a_plane_at_its_support) {
  // Support of an ellipse at angle phi: sqrt(a^2 sin^2 + b^2 cos^2) below its centre.
  const Pose ground{};
  for (const double angle : {0.0, 0.4, 1.1, 2.0, -0.7}) {
    const Pose body{{0.3, 2.0}, rotation(angle), {}, 0.0};
    const double support = std::hypot(1.25 * std::sin(angle), 4.0 * std::cos(angle));
    BOOST_TEST(gap(outline(2.0), body, HalfPlane{}, ground).depth == support - 2.0,
               boost::test_tools::tolerance(1e-13));
  }
}

BOOST_AUTO_TEST_CASE(side_faces_and_rays_change_sign_on_the_outline) {
  for (int i = 0; i < 64; ++i) {
    const Vec2 p = boundary_point(outline(20.0), 0.05 + 2.0 * pi * i / 64);
    for (const double ratio : {0.999, 1.001}) {
      const Vec2 near = ratio * p;
      BOOST_TEST((depth_below(SideFaces{outline(20.0)}, near).depth > 0.0) == (ratio < 1.0));
      BOOST_TEST((depth_below(CentroidRays{outline(20.0)}, near).depth > 0.0) == (ratio < 1.0));
    }
  }
  BOOST_TEST(depth_below(SideFaces{outline(20.0)}, {-1.0, 0.5}).depth == 0.25);
  BOOST_TEST(depth_below(SideFaces{outline(20.0)}, {-1.0, 0.5}).normal.x == -1.0);
  const Depth ray = depth_below(CentroidRays{outline(20.0)}, {1.0, 0.0});
  BOOST_TEST(ray.depth == 0.25, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(solids_have_the_masses_that_the_listing_of_sample2_prints) {
  // Mustoe & Huttelmaier 1993, Appendix II.5.2: 40.00, 1337; 37.23, 21.48; 29.85, 170.8 (four digits).
  BOOST_TEST(std::abs(block(10.0, 0.5, 0.1).mass - 40.0) < 5e-3);
  BOOST_TEST(std::abs(block(10.0, 0.5, 0.1).inertia - 1337.0) < 0.5);
  BOOST_TEST(std::abs(ellipsoid(1.201, 1.201, 5.13).mass - 37.23) < 5e-3);
  BOOST_TEST(std::abs(ellipsoid(1.201, 1.201, 5.13).inertia - 21.48) < 5e-3);
  BOOST_TEST(std::abs(cylinder(1.25, 4.0, 0.76).mass - 29.85) < 1e-2);
  BOOST_TEST(std::abs(cylinder(1.25, 4.0, 0.76).inertia - 170.8) < 5e-2);
}

BOOST_AUTO_TEST_CASE(curvature_and_normal_at_known_points) {
  // A circle's curvature is constant; at 45 degrees of a = b = 1 it is (n - 1) 2^(1/n - 1/2) (derived from the
  // gradient's formula).
  for (const double t : {0.3, 1.1, 2.5, 4.0}) {
    const Superquadric circle{2.0, 2.0, 2.0};
    const Vec2 p = boundary_point(circle, t);
    BOOST_TEST(curvature(circle, p) == 0.5, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(norm(outward_normal(circle, p) - 0.5 * p) < 1e-12);
  }
  for (const double n : {2.0, 3.0, 8.0, 20.0}) {
    const double c = std::pow(0.5, 1.0 / n);
    const Superquadric blunt{1.0, 1.0, n};
    BOOST_TEST(curvature(blunt, {c, c}) == (n - 1.0) * std::pow(2.0, 1.0 / n - 0.5),
               boost::test_tools::tolerance(1e-11));
  }
  BOOST_TEST(curvature(Superquadric{1.0, 4.0, 20.0}, {1.0, 0.0}) == 0.0);
}

BOOST_AUTO_TEST_CASE(the_smoother_outline_gives_the_normal) {
  // The flat side of a column (its node in the middle of the side) overlaps a circle by 0.01: at the node, which lies
  // inside the circle off its centre line, the normal is that of the side, not the radial one.
  const Superquadric circle{1.0, 1.0, 2.0};
  const Pose column{{1.99, 0.2}, rotation(0.0), {}, 0.0}, rock{{0.0, 0.0}, rotation(0.0), {}, 0.0};
  const Ball node{{-1.0, 0.0}, 0.0};
  const Depth radial = ball_depth(node, placement(column, rock), circle);
  const Depth flat = ball_depth(node, placement(column, rock), Smoother{circle, {-1.0, 0.0}, 0.0});
  BOOST_TEST(radial.normal.y > 0.1);
  BOOST_TEST(flat.normal.x == 1.0);
  BOOST_TEST(flat.normal.y == 0.0);
  BOOST_TEST(flat.depth == radial.depth / radial.normal.x, boost::test_tools::tolerance(1e-12));
  // A node on an outline with larger curvature than the circle uses the circle's normal.
  const Depth sharp = ball_depth(node, placement(column, rock), Smoother{circle, {-1.0, 0.0}, 50.0});
  BOOST_TEST(sharp.normal.y == radial.normal.y);
}

BOOST_AUTO_TEST_CASE(nearest_point_beside_a_sharp_corner) {
  // A point inside a corner, at similar distances from both sides, may have two local minima of the distance to the
  // outline, close to each other: no point of the outline may be nearer than the one found.
  std::mt19937_64 random{5};
  std::uniform_real_distribution<double> ratio{0.0, 1.0};
  for (const double n : {20.0, 50.0, 200.0}) {
    const Superquadric shape{1.0, 0.7, n};
    std::vector<Vec2> outline;
    for (int i = 0; i <= 2000; ++i)
      outline.push_back(boundary_point(shape, 0.5 * std::numbers::pi * i / 2000));
    int farther = 0;
    for (int i = 0; i < 2000; ++i) {
      const double in = 0.01 + 0.09 * ratio(random);  // similar distances from both sides
      const Vec2 p{1.0 - in * (0.9 + 0.2 * ratio(random)), 0.7 - in};
      double minimum = 1.0;
      for (const Vec2 q : outline)
        minimum = std::min(minimum, norm(q - p));
      if (depth_below(shape, p).depth > minimum + 1e-14) ++farther;
    }
    BOOST_TEST(farther == 0, "n = " << n << ": " << farther);
  }
}

BOOST_AUTO_TEST_CASE(powers_have_the_bits_of_the_plain_routine) {
  std::mt19937_64 random{11};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  int different = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double base = i % 2 == 0 ? unit(random) : std::exp(80.0 * unit(random) - 60.0);
    const double exponent = 0.01 + 12.0 * unit(random);
    different += power(base, exponent) != Sleef_cinz_powd1_u10purec(base, exponent);
    // boundary_point() raises both at once.
    const Superquadric shape{1.25, 4.0, 1.0 + 5.0 * unit(random)};
    const double t = 0.5 * pi * unit(random);
    const Vec2 point = boundary_point(shape, t);
    const Rotation turned = rotation(t);
    different += point.x != 1.25 * Sleef_cinz_powd1_u10purec(turned.cosine, 2.0 / shape.exponent);
    different += point.y != 4.0 * Sleef_cinz_powd1_u10purec(turned.sine, 2.0 / shape.exponent);
  }
  BOOST_TEST(different == 0);
  for (const double base : {0.0, 1.0, 5e-324, 1e308})
    BOOST_TEST(power(base, 2.5) == Sleef_cinz_powd1_u10purec(base, 2.5));
}

BOOST_AUTO_TEST_SUITE_END()
