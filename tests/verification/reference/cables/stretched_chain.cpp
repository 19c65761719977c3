#include "verification/reference/cables/stretched_chain.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "verification/reference/mathematics/trajectory.hpp"

BOOST_AUTO_TEST_SUITE(stretched_chain_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr ref::StretchedChain chain{7, 2.0, 50.0};

}  // namespace

BOOST_AUTO_TEST_CASE(shapes_satisfy_the_equation) {
  const auto w = ref::chain_frequencies(chain);
  BOOST_REQUIRE(w.size() == 7u);
  for (int j = 1; j <= 7; ++j) {
    const auto s = ref::chain_shape(chain, j);
    double square = 0.0;
    for (std::size_t i = 0; i < 7; ++i) {
      const double after = i < 6 ? s[i + 1] : 0.0, before = i > 0 ? s[i - 1] : 0.0;
      const double frequency = w[static_cast<std::size_t>(j - 1)];
      BOOST_TEST(std::abs(2.0 * frequency * frequency * s[i] + 50.0 * (after - 2.0 * s[i] + before)) < 200.0 * 4 * eps);
      square += s[i] * s[i];
    }
    BOOST_TEST(std::abs(square - 4.0) < 16 * eps);
  }
}

BOOST_AUTO_TEST_CASE(a_mode_swings_as_integrated) {
  const auto s = ref::chain_shape(chain, 3);
  const double w = ref::chain_frequencies(chain)[2];
  const auto rates = [](const ref::Coordinates& y, ref::Coordinates& dydt) {
    for (std::size_t i = 0; i < 7; ++i) {
      dydt[i] = y[i + 7];
      dydt[i + 7] = 25.0L * ((i < 6 ? y[i + 1] : 0.0L) - 2.0L * y[i] + (i > 0 ? y[i - 1] : 0.0L));
    }
  };
  ref::Coordinates start(14, 0.0L);
  for (std::size_t i = 0; i < 7; ++i)
    start[i] = s[i];
  ref::Trajectory truth(rates, start, 0.0L, 0.01L);
  truth.advance_to(2.3L);
  for (std::size_t i = 0; i < 7; ++i)
    BOOST_TEST(std::abs(s[i] * std::cos(w * 2.3) - static_cast<double>(truth.coordinates()[i])) < 1e-14);
}

BOOST_AUTO_TEST_CASE(difference_equation_has_this_frequency_and_this_growth) {
  for (const double wh : {0.01, 0.5, 1.3, 1.99}) {
    double before = 1.0, now = 1.0 - 0.5 * wh * wh;  // q(0) = 1 at rest
    for (int s = 1; s < 50; ++s) {
      const double after = 2.0 * now - before - wh * wh * now;
      before = now, now = after;
    }
    // 50 steps that each round to eps and are summed twice, magnified by 1/sin(W h) near the limit
    BOOST_TEST(std::abs(now - std::cos(50.0 * ref::leapfrog_frequency(wh, 1.0))) < 2500 * eps);
  }
  for (const double wh : {2.001, 2.5}) {
    const double g = ref::leapfrog_growth(wh, 1.0);
    BOOST_TEST(g + 1.0 / g == wh * wh - 2.0, boost::test_tools::tolerance(4 * eps));
    BOOST_TEST(g > 1.0);
  }
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::chain_frequencies({0, 1.0, 1.0}), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::leapfrog_frequency(2.1, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::leapfrog_growth(1.9, 1.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
