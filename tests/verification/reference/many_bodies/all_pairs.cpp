#include "verification/reference/many_bodies/all_pairs.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(all_pairs_tests)

using talus::verification::reference::AllPairs;

namespace {

AllPairs two(double damping) {
  return {.stiffness = 0.5,
          .damping = damping,
          .radius = {0.4, 0.6},
          .inverse_mass = {1.0, 1.0},
          .x = {-0.5, 0.5},
          .y = {0.0, 0.0},
          .vx = {0.001, -0.001},
          .vy = {0.0, 0.0}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_discs_swap_their_speeds_in_half_a_period) {
  // w = sqrt(2 k/m) = 1: they separate after pi.
  AllPairs discs = two(0.0);
  constexpr int steps = 2000;
  for (int n = 0; n < steps; ++n)
    discs.step(1.05 * std::numbers::pi / steps);
  BOOST_TEST(discs.vx[0] == -0.001, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(discs.vx[1] == 0.001, boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(a_dashpot_takes_speed_and_none_from_the_pair_as_a_whole) {
  AllPairs discs = two(0.1);
  discs.vy = {0.002, 0.002};
  for (int n = 0; n < 2000; ++n)
    discs.step(0.002);
  BOOST_TEST(discs.vx[1] < 0.0009);
  BOOST_TEST(discs.vx[1] > 0.0003);
  BOOST_TEST(discs.vx[0] + discs.vx[1] == 0.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(discs.vy[0] == 0.002);
}

BOOST_AUTO_TEST_CASE(discs_apart_fly_on) {
  AllPairs discs = two(0.0);
  discs.x = {-2.0, 2.0};
  discs.step(10.0);
  BOOST_TEST(discs.x[0] == -1.99);
  BOOST_TEST(discs.vx[0] == 0.001);
}

BOOST_AUTO_TEST_SUITE_END()
