#include "verification/reference/many_bodies/virtual_discs.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(virtual_discs_tests)

using talus::verification::reference::VirtualDiscs;

namespace {

/// Two free discs, and three in each wall out of their reach.
VirtualDiscs pair(double apart, double speed) {
  VirtualDiscs discs{.k1 = 4.9e3,
                     .k2 = 1e4,
                     .diameter = 1.0,
                     .mass = 1.0,
                     .left = 0.0,
                     .width = 4.0,
                     .gravity = 0.0,
                     .block_mass = 10.0,
                     .free = 2,
                     .wall = 3,
                     .x = {},
                     .y = {},
                     .vx = {},
                     .vy = {}};
  discs.x = {2.0 - 0.5 * apart, 2.0 + 0.5 * apart, 0.5, 1.5, 2.5, 0.5, 1.5, 2.5};
  discs.y = {5.0, 5.0, 0.0, 0.0, 0.0, 10.0, 10.0, 10.0};
  discs.vx = {0.5 * speed, -0.5 * speed, 0, 0, 0, 0, 0, 0};
  discs.vy.assign(8, 0.0);
  return discs;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_impact_keeps_the_square_root_of_k1_over_k2) {
  VirtualDiscs discs = pair(1.01, 1.0);
  const double contact = 0.5 * std::numbers::pi * (1.0 / std::sqrt(9.8e3) + 1.0 / std::sqrt(2e4)), h = contact / 500.0;
  for (int n = 0; n < 2000; ++n)
    discs.step(h);
  BOOST_TEST(discs.vx[1] == 0.5 * 0.7, boost::test_tools::tolerance(2e-4));
  BOOST_TEST(discs.vx[0] == -discs.vx[1]);
}

BOOST_AUTO_TEST_CASE(an_impact_across_the_border_is_the_same) {
  VirtualDiscs here = pair(1.01, 1.0), across = here;
  for (std::size_t i : {0U, 1U})
    across.x[i] -= 2.0;
  across.x[0] += 4.0;
  for (int n = 0; n < 400; ++n)
    here.step(1e-4), across.step(1e-4);
  BOOST_TEST(std::abs(here.vx[0]) < 0.45);
  BOOST_TEST(across.vx[0] == here.vx[0], boost::test_tools::tolerance(1e-11));
  BOOST_TEST(across.vx[1] == here.vx[1], boost::test_tools::tolerance(1e-11));
}

BOOST_AUTO_TEST_CASE(the_block_falls_as_one_and_what_it_meets_is_counted) {
  VirtualDiscs discs = pair(1.5, 0.0);
  discs.gravity = 9.81;
  for (int n = 0; n < 100; ++n)
    discs.step(1e-3);
  BOOST_TEST(discs.vy[5] == -0.981, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(discs.vy[7] == discs.vy[5]);
  discs.y[0] = discs.y[6] - 0.9, discs.x[0] = discs.x[6];
  discs.step(1e-3);
  BOOST_TEST(discs.force_on_block_y == 4.9e3 * 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(discs.vy[0] == -0.49, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
