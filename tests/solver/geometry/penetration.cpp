/// The overlap of two outlines over all directions (solver/geometry/penetration.hpp), compared with independent
/// methods.
#include "solver/geometry/penetration.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/geometry/gap.hpp"

BOOST_AUTO_TEST_SUITE(penetration_tests)

using namespace talus;
using boost::test_tools::tolerance;

namespace {

Pose at(double x, double y, double angle = 0.0) { return {{x, y}, rotation(angle), {}, 0.0}; }

}  // namespace

BOOST_AUTO_TEST_CASE(crossed_bars_overlap_by_their_half_sides) {
  const Shape upright = Rectangle{0.25, 2.0}, level = Rectangle{2.0, 0.25};
  BOOST_TEST(penetration(upright, at(0, 0), level, at(0, 0)) == 2.25);
  BOOST_TEST(penetration(upright, at(0, 2.0), level, at(0, 0)) == 0.25);
  BOOST_TEST(penetration(upright, at(0, 2.5), level, at(0, 0)) == -0.25);
}

BOOST_AUTO_TEST_CASE(rectangles_and_circles_as_by_their_gaps) {
  std::mt19937_64 random{4};
  std::uniform_real_distribution<double> coordinate{-1.5, 1.5}, angle{-std::numbers::pi, std::numbers::pi};
  const Rectangle a{0.9, 0.4}, b{0.3, 1.1};
  const Circle one{0.7}, other{0.4};
  for (int i = 0; i < 200; ++i) {
    const Pose A = at(coordinate(random), coordinate(random), angle(random)),
               B = at(coordinate(random), coordinate(random), angle(random));
    const double sides = gap(a, A, b, B).depth, all = penetration(a, A, b, B);
    BOOST_TEST((all > 0.0) == (sides > 0.0));
    if (sides > 0.0) BOOST_TEST(std::abs(all - sides) < 4e-15);
    BOOST_TEST(std::abs(penetration(one, A, other, B) - gap(Ball{{}, 0.7}, A, other, B).depth) < 2e-15);
    BOOST_TEST(std::abs(penetration(one, A, HalfPlane{}, B) - gap(Ball{{}, 0.7}, A, HalfPlane{}, B).depth) < 2e-15);
  }
}

/// For a circle the overlap is its radius plus the depth of its centre, which is computed from the nearest point.
BOOST_AUTO_TEST_CASE(superquadrics_from_above_to_a_thousandth) {
  std::mt19937_64 random{5};
  std::uniform_real_distribution<double> coordinate{-1.2, 1.2}, angle{-std::numbers::pi, std::numbers::pi};
  for (const double n : {1.5, 2.0, 5.0, 20.0}) {
    const Superquadric outline{1.0, 0.5, n};
    for (int i = 0; i < 100; ++i) {
      const Pose A = at(coordinate(random), coordinate(random)), B = at(0.1, -0.2, angle(random));
      const double exact = gap(Ball{{}, 0.6}, A, outline, B).depth;
      if (exact < 0.0) continue;
      BOOST_TEST(penetration(Circle{0.6}, A, outline, B) >= exact - 1e-12);
      BOOST_TEST(penetration(Circle{0.6}, A, outline, B) <= exact + 1e-3);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_peak_of_terrain_in_a_box) {
  const Terrain peak{{{-5.0, -5.0}, {0.0, 0.0}, {5.0, -5.0}}};
  BOOST_TEST(penetration(Rectangle{1.0, 0.5}, at(0.25, 0.25), peak, at(0, 0)) == 0.25);
  BOOST_TEST(penetration(peak, at(0, 0), Rectangle{1.0, 0.5}, at(0.25, 0.25)) == 0.25);
  BOOST_TEST(!(penetration(Rectangle{1.0, 0.5}, at(0.0, 0.75), peak, at(0, 0)) > 0.0));
  BOOST_TEST(!(penetration(NoShape{}, at(0, 0), peak, at(0, 0)) > 0.0));
}

// Straight terrain of one segment, whose ends are far away, is a half-plane for every outline.
BOOST_AUTO_TEST_CASE(outlines_below_a_segment_of_terrain) {
  const Terrain straight{{{-50.0, 0.0}, {50.0, 0.0}}};
  std::mt19937_64 random{11};
  std::uniform_real_distribution<double> coordinate{-1.5, 1.5}, angle{-std::numbers::pi, std::numbers::pi};
  for (const Shape& shape : {Shape{Circle{0.7}}, Shape{Rectangle{1.0, 0.4}}, Shape{Superquadric{1.0, 0.4, 2.0}},
                             Shape{Superquadric{0.5, 0.9, 7.0}}}) {
    for (int i = 0; i < 50; ++i) {
      const Pose A = at(coordinate(random), coordinate(random), angle(random)), B = at(0.3, -0.2, 0.5 * angle(random));
      const double exact = penetration(shape, A, HalfPlane{}, B);
      BOOST_TEST(std::abs(penetration(shape, A, straight, B) - exact) < 1e-13);
      BOOST_TEST(std::abs(penetration(straight, B, shape, A) - exact) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
