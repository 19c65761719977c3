#include "verification/reference/mathematics/hurwitz_zeta.hpp"

#include <boost/math/special_functions/zeta.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(hurwitz_zeta_tests)

namespace ref = talus::verification::reference;

BOOST_AUTO_TEST_CASE(whole_powers_are_bernoulli_polynomials) {
  for (const double u : {0.01, 0.3, 0.5, 0.77, 1.0}) {
    BOOST_TEST(std::abs(ref::hurwitz_zeta_of_minus(0.0, u) - (0.5 - u)) < 1e-15);
    BOOST_TEST(std::abs(ref::hurwitz_zeta_of_minus(1.0, u) + 0.5 * (u * u - u + 1.0 / 6.0)) < 1e-15);
    BOOST_TEST(std::abs(ref::hurwitz_zeta_of_minus(2.0, u) + (u * u * u - 1.5 * u * u + 0.5 * u) / 3.0) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(at_one_it_is_riemanns) {
  for (const double p : {-0.5, 0.25, 1.5, 2.5, 3.7})
    BOOST_TEST(std::abs(ref::hurwitz_zeta_of_minus(p, 1.0) - boost::math::zeta(-p)) < 5e-13);
}

BOOST_AUTO_TEST_CASE(shifts_by_one_term_and_has_the_mean_zero) {
  for (const double p : {0.25, 1.5}) {
    // zeta(-p, 1/2) = (2^-p - 1) zeta(-p).
    BOOST_TEST(std::abs(ref::hurwitz_zeta_of_minus(p, 0.5) - (std::pow(2.0, -p) - 1.0) * boost::math::zeta(-p)) <
               1e-14);
    // The sum over n equally spaced u is n^-p zeta(-p, n u): the multiplication theorem.
    double sum = 0.0;
    for (int i = 0; i < 5; ++i)
      sum += ref::hurwitz_zeta_of_minus(p, (0.4 + i) / 5.0);
    BOOST_TEST(std::abs(sum - std::pow(5.0, -p) * ref::hurwitz_zeta_of_minus(p, 0.4)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::hurwitz_zeta_of_minus(-1.0, 0.5), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::hurwitz_zeta_of_minus(1.0, 0.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
