#include "verification/reference/cables/hanging_chain.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(hanging_chain_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr ref::HangingChain chain{9, 0.15, 0.125, 1.0, 0.25};

}  // namespace

BOOST_AUTO_TEST_CASE(joints_are_in_balance_and_links_have_their_length) {
  for (const double compliance : {0.0, 0.01, 0.5}) {
    const auto hung = ref::hung_chain(chain, compliance);
    BOOST_REQUIRE(hung.x.size() == 9u);
    BOOST_REQUIRE(hung.tension.size() == 10u);
    const auto x = [&](std::size_t i) { return i == 0 ? 0.0 : i == 10 ? chain.span : hung.x[i - 1]; };
    const auto y = [&](std::size_t i) { return i == 0 ? 0.0 : i == 10 ? chain.rise : hung.y[i - 1]; };
    for (std::size_t i = 0; i < 10; ++i) {
      const double whole = std::hypot(x(i + 1) - x(i), y(i + 1) - y(i));
      BOOST_TEST(std::abs(whole - chain.link - compliance * hung.tension[i]) < 8 * eps);
      if (i == 0) continue;
      const double before = std::hypot(x(i) - x(i - 1), y(i) - y(i - 1));
      const double across =
          hung.tension[i] * (x(i + 1) - x(i)) / whole - hung.tension[i - 1] * (x(i) - x(i - 1)) / before;
      const double up = hung.tension[i] * (y(i + 1) - y(i)) / whole - hung.tension[i - 1] * (y(i) - y(i - 1)) / before;
      BOOST_TEST(std::abs(across) < 40 * eps);
      BOOST_TEST(std::abs(up - chain.weight) < 40 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(softening_is_the_rate_of_the_places) {
  const auto rate = ref::softening(chain);
  const auto at = ref::hung_chain(chain, 0.0), near = ref::hung_chain(chain, 1e-5), far = ref::hung_chain(chain, 2e-5);
  const auto slope = [](double f0, double f1, double f2) { return (4.0 * f1 - 3.0 * f0 - f2) / 2e-5; };
  for (std::size_t i = 0; i < 9; ++i) {
    // Error: the third derivative, below 300, times 1e-10/3.
    BOOST_TEST(std::abs(slope(at.x[i], near.x[i], far.x[i]) - rate.x[i]) < 1e-7);
    BOOST_TEST(std::abs(slope(at.y[i], near.y[i], far.y[i]) - rate.y[i]) < 1e-7);
    BOOST_TEST(std::abs(slope(at.tension[i], near.tension[i], far.tension[i]) - rate.tension[i]) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(many_links_hang_in_a_catenary) {
  // Ends at the same height, a = 1 apart, length 2 p sinh(1/(2 p)) = 1.5; the sag is p (cosh(1/(2 p)) - 1).
  double low = 0.1, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double p = 0.5 * (low + high);
    (2.0 * p * std::sinh(0.5 / p) > 1.5 ? low : high) = p;
  }
  const double sag = low * (std::cosh(0.5 / low) - 1.0);
  const auto error = [&](int links) {
    const auto hung = ref::hung_chain({links - 1, 1.5 / links, 1.0 / links, 1.0, 0.0}, 0.0);
    return -hung.y[static_cast<std::size_t>(links / 2 - 1)] - sag;
  };
  BOOST_TEST(std::abs(error(64)) < 1e-3);
  BOOST_TEST(error(64) / error(128) == 4.0, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::hung_chain({9, 0.05, 0.1, 1.0, 0.0}, 0.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::hung_chain({0, 0.5, 0.1, 1.0, 0.0}, 0.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
