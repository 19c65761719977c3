#include "verification/reference/many_bodies/pressed_discs.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "verification/reference/mathematics/trajectory.hpp"

BOOST_AUTO_TEST_SUITE(pressed_discs_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace

BOOST_AUTO_TEST_CASE(column_is_in_balance) {
  const auto overlaps = ref::column_overlaps(10, 2.0, 9.81, 500.0);
  BOOST_REQUIRE(overlaps.size() == 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    const double above = i + 1 < 10 ? 500.0 * overlaps[i + 1] : 0.0;
    BOOST_TEST(500.0 * overlaps[i] - above == 2.0 * 9.81, boost::test_tools::tolerance(40 * eps));
  }
}

BOOST_AUTO_TEST_CASE(column_shape_swings_at_its_frequency) {
  const double w = ref::column_frequency(10, 2.0, 500.0);
  const auto shape = [](int i) { return std::sin(std::numbers::pi * i / 21.0); };
  for (int i = 1; i <= 10; ++i) {
    const double up = i < 10 ? shape(i + 1) - shape(i) : 0.0;
    const double down = shape(i - 1) - shape(i);
    BOOST_TEST(std::abs(2.0 * w * w * shape(i) + 500.0 * (up + down)) < 500.0 * 8 * eps);
  }
}

BOOST_AUTO_TEST_CASE(pair_matches_a_tight_integration) {
  const ref::PressedPairState start{{0.3, -0.1}, {0.2, 0.7}};
  for (const double lag : {0.0, 0.02}) {
    for (const double above : {1.0, 2.5}) {
      const ref::PressedPair pair{1.0, above, 40.0, lag, 9.81};
      const auto force = [=](long double y, long double v) { return 40.0L * (y + lag * v); };
      const auto rates = [=](const ref::Coordinates& y, ref::Coordinates& dydt) {
        const long double floor = -force(y[0], y[2]), between = force(y[0] - y[1], y[2] - y[3]),
                          ceiling = force(y[1], y[3]);
        dydt[0] = y[2];
        dydt[1] = y[3];
        dydt[2] = floor - between - 9.81L;
        dydt[3] = (between - ceiling) / above - 9.81L;
      };
      ref::Trajectory truth(rates, {0.3L, -0.1L, 0.2L, 0.7L}, 0.0L, 0.01L);
      for (const double t : {0.0, 0.1, 0.4, 1.7}) {
        truth.advance_to(t);
        const ref::PressedPairState found = ref::pair_at(pair, start, t);
        for (std::size_t i = 0; i < 2; ++i) {
          BOOST_TEST(std::abs(found.height[i] - static_cast<double>(truth.coordinates()[i])) < 1e-14);
          BOOST_TEST(std::abs(found.rate[i] - static_cast<double>(truth.coordinates()[i + 2])) < 2e-14);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(equal_pair_has_the_textbook_frequencies) {
  const auto w = ref::pair_frequencies({2.0, 2.0, 50.0, 0.0, 0.0});
  BOOST_TEST(w[0] == 5.0, boost::test_tools::tolerance(2 * eps));
  BOOST_TEST(w[1] == 5.0 * std::sqrt(3.0), boost::test_tools::tolerance(2 * eps));
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::pair_at({1.0, 1.0, 1.0, 5.0, 0.0}, {}, 1.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
