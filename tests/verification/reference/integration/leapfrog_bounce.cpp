#include "verification/reference/integration/leapfrog_bounce.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(leapfrog_bounce_tests)

namespace ref = talus::verification::reference;

BOOST_AUTO_TEST_CASE(closed_form_is_the_recurrence) {
  for (const double eta : {0.05, 0.3, 0.7, 1.2, 1.6, 1.95}) {
    for (double theta = 0.0137; theta <= 1.0; theta += 0.0731) {
      double before = theta - 1.0, now = theta;
      long steps = 0;
      while (now > 0.0) {
        const double next = 2.0 * now - before - eta * eta * now;
        before = now, now = next;
        ++steps;
      }
      const auto bounce = ref::leapfrog_bounce(eta, theta);
      BOOST_TEST(bounce.ratio == before - now, boost::test_tools::tolerance(1e-11));
      BOOST_TEST(bounce.steps == steps);
    }
  }
}

BOOST_AUTO_TEST_CASE(invariant_and_bound) {
  for (const double eta : {0.1, 0.7, 1.6, 1.9}) {
    for (double theta = 0.003; theta <= 1.0; theta += 0.0171) {
      const auto bounce = ref::leapfrog_bounce(eta, theta);
      const double left = 1.0 - eta * eta * theta * (1.0 - theta);
      const double right = 1.0 - eta * eta * bounce.phase * (1.0 - bounce.phase);
      BOOST_TEST(bounce.ratio * bounce.ratio * right == left, boost::test_tools::tolerance(1e-11));
      BOOST_TEST(bounce.ratio <= 1.0 / std::sqrt(1.0 - 0.25 * eta * eta) * (1.0 + 1e-12));
    }
  }
  BOOST_CHECK_THROW((void)ref::leapfrog_bounce(2.0, 0.5), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::leapfrog_bounce(1.0, 0.0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(mean_of_the_inverse_square_is_one_and_the_mean_logarithm_positive) {
  for (const double eta : {0.1, 0.2, 0.3, 0.7, 1.2, 1.6, 1.9}) {
    const auto gain = ref::leapfrog_gain(eta, 200000);
    BOOST_TEST(std::abs(gain.inverse_square - 1.0) < 1e-6);
    BOOST_TEST(gain.mean_ln > 0.0);
  }
  // The difference is of the next order in eta.
  for (const double eta : {0.1, 0.2, 0.3})
    BOOST_TEST(std::abs(ref::leapfrog_gain(eta, 200000).mean_ln / ref::small_step_heating(eta) - 1.0) < eta * eta);
}

BOOST_AUTO_TEST_SUITE_END()
