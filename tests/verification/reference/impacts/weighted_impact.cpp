#include "verification/reference/impacts/weighted_impact.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

#include "verification/reference/impacts/restitution.hpp"

BOOST_AUTO_TEST_SUITE(weighted_impact_tests)

using namespace talus::verification::reference;

BOOST_AUTO_TEST_CASE(without_gravity_it_is_the_impact_in_closed_form) {
  for (const EndRule end : {EndRule::clamped, EndRule::attractive}) {
    for (const double damping : {0.0, 50.0, 400.0, 800.0}) {  // up to 0.89 of the critical one
      const WeightedRebound found = weighted_rebound({2.0, 1e5, damping, 0.0, 3.0}, end);
      const ImpactEvents exact = impact_events({1e5, damping, 2.0, 3.0}, end);
      BOOST_TEST(found.restitution == exact.restitution, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(found.release_speed == 3.0 * exact.restitution, boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(without_dashpot_the_speed_at_the_surface_is_that_at_touch) {
  for (const double gravity : {0.0, 10.0, 100.0})
    BOOST_TEST(weighted_rebound({2.0, 1e5, 0.0, gravity, 3.0}, EndRule::clamped).restitution == 1.0,
               boost::test_tools::tolerance(1e-12));
}

// Thrown up with less than the overlap that is left.
BOOST_AUTO_TEST_CASE(a_weight_can_keep_it_below_the_surface) {
  const WeightedRebound found = weighted_rebound({2.0, 1e5, 800.0, 10.0, 1.0}, EndRule::clamped);
  BOOST_TEST(found.restitution == 0.0);
  BOOST_TEST(found.release_speed > 0.0);
  BOOST_CHECK_THROW(static_cast<void>(weighted_rebound({2.0, 1e5, 800.0, 20.0, 1.0}, EndRule::clamped)),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
