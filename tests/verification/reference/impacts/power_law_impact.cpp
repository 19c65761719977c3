#include "verification/reference/impacts/power_law_impact.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/reference/impacts/hertz_impact.hpp"

BOOST_AUTO_TEST_SUITE(power_law_impact_tests)

namespace ref = talus::verification::reference;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_CASE(without_damping_the_events_are_those_of_the_spring) {
  const ref::ScaledEvents linear = ref::hunt_crossley_events(0.0, 1.0);
  BOOST_TEST(linear.restitution == 1.0, tolerance(1e-15));
  BOOST_TEST(linear.contact_time == std::numbers::pi, tolerance(1e-15));
  BOOST_TEST(linear.largest_depth == 1.0, tolerance(1e-15));
  for (const ref::ScaledEvents& hertz :
       {ref::hunt_crossley_events(0.0, 1.5), ref::constant_dashpot_events(0.0, ref::EndRule::clamped)}) {
    BOOST_TEST(hertz.restitution == 1.0, tolerance(1e-15));
    BOOST_TEST(hertz.largest_depth == std::pow(1.25, 0.4), tolerance(1e-15));
    BOOST_TEST(hertz.contact_time == ref::hertz_time_factor() * hertz.largest_depth, tolerance(1e-14));
  }
  // Energy: X^3/3 = 1/2.
  BOOST_TEST(ref::hunt_crossley_events(0.0, 2.0).largest_depth == std::cbrt(1.5), tolerance(1e-15));
}

// The closed form against the integration, which knows nothing of it.
BOOST_AUTO_TEST_CASE(restitution_does_not_depend_on_the_exponent) {
  for (const double a : {0.01, 0.3, 1.0, 4.0}) {
    for (const double n : {1.0, 1.5, 2.0})
      BOOST_TEST(ref::hunt_crossley_events(a, n).restitution == ref::hunt_crossley_restitution(a), tolerance(1e-14));
    BOOST_TEST(ref::hunt_crossley_number(ref::hunt_crossley_restitution(a)) == a, tolerance(1e-13));
  }
}

// To first order in g the energy lost is g int X' dX along the undamped path: 1 - e^2 = 2 (2 g) int_0^{X_m} w dX, with
// w^2 = 1 - (4/5) X^(5/2), and the attractive rule.
BOOST_AUTO_TEST_CASE(a_weak_dashpot_takes_its_work_along_the_undamped_path) {
  const double g = 1e-5, maximum = std::pow(1.25, 0.4);
  double path = 0.0;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double s = (i + 0.5) / count, x = maximum * (1.0 - s * s);
    path += std::sqrt(1.0 - 0.8 * std::pow(x, 2.5)) * 2.0 * maximum * s / count;
  }
  const double e = ref::constant_dashpot_events(g, ref::EndRule::attractive).restitution;
  BOOST_TEST((1.0 - e * e) / (4.0 * g * path) == 1.0, tolerance(5e-5));
}

BOOST_AUTO_TEST_CASE(what_has_no_answer_is_refused) {
  BOOST_CHECK_THROW((void)ref::constant_dashpot_events(5.0, ref::EndRule::attractive), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::hunt_crossley_events(1.0, 1.2), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::hunt_crossley_restitution(0.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::hunt_crossley_number(1.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
