#define BOOST_TEST_MODULE cell_profile
#include "solver/granular/cell_profile.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

using namespace talus;

BOOST_AUTO_TEST_CASE(layers_share_a_disc_by_its_area) {
  CellProfile profile{4, 1.0, 5.0};
  // A quarter of its height above y = 2: a segment of 60 degrees to either side.
  profile.add({.y = 1.5, .vx = 3.0, .vy = 4.0, .radius = 1.0, .mass = 2.0, .spin = -5.0}, 0.5);
  profile.add_time(0.5);
  const auto layers = profile.layers();
  const double cap = std::numbers::pi / 3.0 - std::sqrt(3.0) / 4.0;
  BOOST_TEST(layers[2].fraction == cap / 5.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers[0].fraction == cap / 5.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers[1].fraction == (std::numbers::pi - 2.0 * cap) / 5.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers[3].fraction == 0.0);
  BOOST_TEST(layers[1].velocity == 3.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(layers[1].temperature == 16.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers[1].spin == -5.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(layers[3].spin == 0.0);
  BOOST_TEST(layers[2].y == 2.5);
}

BOOST_AUTO_TEST_CASE(temperature_is_about_the_mean_of_the_layer) {
  CellProfile profile{1, 10.0, 5.0};
  for (const double u : {-1.0, 1.0, 3.0})
    profile.add({.y = 5.0, .vx = u, .vy = 0.0, .radius = 1.0, .mass = 2.0, .spin = u}, 1.0);
  profile.add_time(1.0);
  BOOST_TEST(profile.layers()[0].velocity == 1.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(profile.layers()[0].spin == 1.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(profile.layers()[0].temperature == 8.0 / 3.0, boost::test_tools::tolerance(1e-14));
}
