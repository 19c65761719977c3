#include "solver/cell/cell_profile.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(cell_profile_tests)

using namespace talus;

BOOST_AUTO_TEST_CASE(layers_share_a_disc_by_its_area) {
  CellProfile profile{1.0, 5.0, 0.0, 1.0};
  profile.look(0.2, 0.5);
  // A quarter of its height is above y = 2: a segment of 60 degrees to either side.
  profile.add({.y = 1.5, .vx = 3.0, .vy = 4.0, .radius = 1.0, .mass = 2.0, .spin = -5.0});
  const auto layers = profile.layers();
  const double cap = std::numbers::pi / 3.0 - std::sqrt(3.0) / 4.0;
  BOOST_TEST(layers[2].fraction.value == cap / 5.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers[0].fraction.value == cap / 5.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers[1].fraction.value == (std::numbers::pi - 2.0 * cap) / 5.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers.size() == 3U);
  BOOST_TEST(layers[1].velocity.value == 3.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(layers[1].temperature.value == 16.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers[1].spin.value == -5.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(layers[2].y == 2.5);
}

BOOST_AUTO_TEST_CASE(temperature_is_about_the_mean_of_the_layer) {
  CellProfile profile{10.0, 5.0, 0.0, 1.0};
  profile.look(0.2, 1.0);
  for (const double u : {-1.0, 1.0, 3.0})
    profile.add({.y = 5.0, .vx = u, .vy = 0.0, .radius = 1.0, .mass = 2.0, .spin = u});
  BOOST_TEST(profile.layers()[0].velocity.value == 1.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(profile.layers()[0].spin.value == 1.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(profile.layers()[0].temperature.value == 8.0 / 3.0, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(errors_are_those_of_the_blocks_of_time) {
  // Three samples in each tenth of the time, of discs with the speed of that tenth: the standard error of the mean is
  // that of the ten speeds. A value that is constant in time has no error.
  CellProfile profile{2.0, 5.0, 1.0, 3.0};
  const std::array<double, CellProfile::blocks> speeds{3.0, -1.0, 4.0, 1.0, -5.0, 9.0, 2.0, 6.0, -5.0, 3.5};
  double mean = 0.0, squares = 0.0;
  for (std::size_t block = 0; block < speeds.size(); ++block) {
    mean += speeds[block] / 10.0;
    for (const double part : {0.1, 0.5, 0.9}) {
      profile.look(1.0 + 0.2 * (static_cast<double>(block) + part), 0.25);
      profile.add({.y = 1.0, .vx = speeds[block], .vy = 0.0, .radius = 1.0, .mass = 2.0, .spin = 7.0});
    }
  }
  for (const double speed : speeds)
    squares += (speed - mean) * (speed - mean);
  const auto layers = profile.layers();
  BOOST_TEST(layers[0].velocity.value == mean, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers[0].velocity.error == std::sqrt(squares / 90.0), boost::test_tools::tolerance(1e-13));
  BOOST_TEST(layers[0].spin.value == 7.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(layers[0].spin.error < 1e-14);
  BOOST_TEST(layers[0].fraction.error < 1e-15);
  BOOST_TEST(layers[0].temperature.error > 0.0);
}

BOOST_AUTO_TEST_CASE(no_disc_is_too_high) {
  // Discs that are added later are higher: no area is lost, and earlier discs stay in their layers.
  CellProfile profile{1.0, 5.0, 0.0, 1.0};
  double area = 0.0;
  for (const double y : {0.5, 7.3, 30.2}) {
    profile.look(0.5, 1.0);
    profile.add({.y = y, .vx = y, .vy = 0.0, .radius = 0.5, .mass = 2.0, .spin = 0.0});
    area += 0.25 * std::numbers::pi;
  }
  double found = 0.0;
  for (const auto& layer : profile.layers())
    found += 3.0 * 5.0 * layer.fraction.value;
  BOOST_TEST(found == area, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(profile.layers().size() == 31U);
  BOOST_TEST(profile.layers()[0].velocity.value == 0.5, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(profile.layers()[15].fraction.value == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
