/// Bounds of moments of inertia by outlines (solver/stability/inertia_bound.hpp).
#include "solver/stability/inertia_bound.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/model/model_builder.hpp"

BOOST_AUTO_TEST_SUITE(inertia_bound_tests)

using namespace talus;

BOOST_AUTO_TEST_CASE(the_largest_distance_is_that_of_the_outline) {
  BOOST_TEST(largest_distance(Circle{0.3}) == 0.3);
  BOOST_TEST(largest_distance(Rectangle{0.3, 0.4}) == 0.5, boost::test_tools::tolerance(1e-15));
  for (const Shape& shape : {Shape{NoShape{}}, Shape{HalfPlane{}}, Shape{Terrain{{{0.0, 0.0}, {1.0, 0.0}}}}})
    BOOST_TEST(std::isinf(largest_distance(shape)));
  for (const double exponent : {1.5, 2.0, 2.001, 3.0, 10.0, 200.0}) {
    for (const double height : {0.02, 0.4, 0.5, 0.8}) {
      const Superquadric shape{0.5, height, exponent};
      double farthest = 0.0;
      for (int i = 0; i <= 200000; ++i) {
        const Vec2 p = boundary_point(shape, 0.5 * std::numbers::pi * i / 200000);
        farthest = std::max(farthest, std::hypot(p.x, p.y));
      }
      BOOST_TEST(largest_distance(shape) == farthest, boost::test_tools::tolerance(1e-6));
    }
  }
}

// A hoop has exactly m R^2; input is rounded to three digits or more.
BOOST_AUTO_TEST_CASE(bodies_beyond_the_bound_are_counted_and_the_worst_is_named) {
  const auto warning = [](double ring, double bar, Mobility mobility) {
    ModelBuilder builder;
    builder.add(Body{.name = "ring", .mass = 2.0, .inertia = ring, .shape = Circle{0.5}});
    builder.add(Body{.name = "bar", .mobility = mobility, .mass = 3.0, .inertia = bar, .shape = Rectangle{0.3, 0.4}});
    builder.add(Body{.name = "point", .mass = 1.0, .inertia = 100.0});
    return inertia_warning(builder.build());
  };
  BOOST_TEST(warning(0.5, 0.75, Mobility::free) == "");
  BOOST_TEST(warning(0.5004, 0.75, Mobility::free) == "");
  BOOST_TEST(warning(0.5, 9.0, Mobility::particle) == "");
  BOOST_TEST(warning(0.5, 0.9, Mobility::free) ==
             "body 'bar': its moment of inertia, 0.9 kg m^2, is more than m R^2 = 0.75 kg m^2, that of its mass, 3 kg, "
             "at the largest distance of its outline from the centre of mass, 0.5 m");
  BOOST_TEST(warning(0.9, 0.9, Mobility::free) ==
             "body 'ring': its moment of inertia, 0.9 kg m^2, is more than m R^2 = 0.5 kg m^2, that of its mass, 2 kg, "
             "at the largest distance of its outline from the centre of mass, 0.5 m; so is that of 1 more body");
}

BOOST_AUTO_TEST_SUITE_END()
