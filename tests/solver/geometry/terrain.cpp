/// Uneven ground compared with the distance to a polyline found by brute force.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "solver/geometry/gap.hpp"

BOOST_AUTO_TEST_SUITE(terrain_tests)

using namespace talus;

namespace {

const Terrain valley{{{-2.0, 1.0}, {-1.0, 0.0}, {0.5, -0.3}, {1.0, 1.5}, {2.0, 1.0}}};

/// Height of the polyline, with its end segments extended.
double height(const Terrain& terrain, double x) {
  std::size_t i = 0;
  while (i + 2 < terrain.points.size() && x > terrain.points[i + 1].x)
    ++i;
  const Vec2 a = terrain.points[i], b = terrain.points[i + 1];
  return a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
}

/// Distance to the polyline by dense sampling.
double distance(const Terrain& terrain, Vec2 p) {
  double minimum = std::numeric_limits<double>::infinity();
  for (double x = p.x - 6.0; x < p.x + 6.0; x += 1e-4)
    minimum = std::min(minimum, norm(p - Vec2{x, height(terrain, x)}));
  return minimum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(depth_is_the_distance_and_its_sign_the_side) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> coordinate{-4.0, 4.0};
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{coordinate(random), coordinate(random)};
    const Depth found = depth_below(valley, p);
    // Adjacent samples are at most 1e-4 sqrt(1 + 3.6^2) apart: the nearest is off by at most half of it.
    BOOST_TEST(std::abs(std::abs(found.depth) - distance(valley, p)) < 2e-4);
    BOOST_TEST((found.depth > 0.0) == (p.y < height(valley, p.x)));
    BOOST_TEST(norm(found.normal) == 1.0, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(the_normal_leads_out) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> coordinate{-3.0, 3.0};
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{coordinate(random), coordinate(random)};
    const Depth found = depth_below(valley, p);
    // A small displacement along the normal reduces the depth by the same amount.
    const double moved = depth_below(valley, p + 1e-7 * found.normal).depth;
    BOOST_TEST(std::abs(found.depth - moved - 1e-7) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(a_level_line_is_a_half_plane) {
  const Terrain level{{{-1.0, 0.0}, {3.0, 0.0}}};
  for (const Vec2 p : {Vec2{-9.0, 2.0}, Vec2{0.0, -1.5}, Vec2{20.0, 0.25}}) {
    const Depth a = depth_below(level, p), b = depth_below(HalfPlane{}, p);
    BOOST_TEST(a.depth == b.depth);
    BOOST_TEST(a.normal.y == b.normal.y);
  }
}

BOOST_AUTO_TEST_CASE(points_on_a_straight_stretch_change_nothing) {
  const Terrain one{{{-2.0, 0.0}, {4.0, 3.0}}};
  const Terrain many{{{-2.0, 0.0}, {0.0, 1.0}, {1.0, 1.5}, {2.0, 2.0}, {4.0, 3.0}}};
  for (const double x : {-1.0, -0.25, 0.0, 0.5, 1.0, 2.0}) {
    for (const double y : {-2.0, 0.1, 1.0, 4.0}) {
      // On the normals through the points, where two segments are equally near.
      const Vec2 p = Vec2{x, 1.0 + 0.5 * x} + y * Vec2{-0.5, 1.0};
      BOOST_TEST(depth_below(many, p).depth == depth_below(one, p).depth, boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
