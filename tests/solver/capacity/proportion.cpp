#include "solver/capacity/proportion.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(proportion_tests)

using namespace talus;

// The ends p of the interval solve (k - n p)^2 = z^2 n p (1 - p).
BOOST_AUTO_TEST_CASE(ends_of_the_interval_are_just_compatible_with_the_trials) {
  for (const std::size_t n : {1U, 4U, 20U, 1000U}) {
    for (std::size_t k = 0; k <= n; k += n > 20 ? 37 : 1) {
      const Interval interval = wilson_interval(k, n);
      for (const double p : {interval.low, interval.high}) {
        if (p == 0.0 || p == 1.0) continue;
        const auto hits = static_cast<double>(k), trials = static_cast<double>(n);
        const double deviation = (hits - trials * p) / std::sqrt(trials * p * (1.0 - p));
        BOOST_TEST(std::abs(deviation) == normal_975, boost::test_tools::tolerance(1e-9));
      }
      BOOST_TEST((interval.low == 0.0) == (k == 0));
      BOOST_TEST((interval.high == 1.0) == (k == n));
    }
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_known_without_trials) {
  const Interval interval = wilson_interval(0, 0);
  BOOST_TEST(interval.low == 0.0);
  BOOST_TEST(interval.high == 1.0);
}

BOOST_AUTO_TEST_CASE(four_equal_outcomes_are_beside_one_half_and_three_are_not) {
  BOOST_TEST(wilson_interval(4, 4).low > 0.5);
  BOOST_TEST(wilson_interval(0, 4).high < 0.5);
  BOOST_TEST(wilson_interval(3, 3).low < 0.5);
}

BOOST_AUTO_TEST_CASE(quantiles_of_a_sample_in_any_order) {
  const SampleQuantile median = sample_quantile({5.0, 1.0, 3.0, 2.0}, 0.5);
  BOOST_TEST(median.value == 2.5);
  BOOST_TEST(sample_quantile({7.0}, 0.95).value == 7.0);
}

// Of 6 values all lie above the median with 1/64 < 2.5 %, of 5 with 1/32 > 2.5 %.
BOOST_AUTO_TEST_CASE(a_small_sample_does_not_bound_its_quantiles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Interval of_six = sample_quantile({1, 2, 3, 4, 5, 6}, 0.5).interval;
  BOOST_TEST(of_six.low == 1.0);
  BOOST_TEST(of_six.high == 6.0);
  const Interval of_five = sample_quantile({1, 2, 3, 4, 5}, 0.5).interval;
  BOOST_TEST(of_five.low == -infinity);
  BOOST_TEST(of_five.high == infinity);
  BOOST_TEST(sample_quantile({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 0.95).interval.high == infinity);
}

BOOST_AUTO_TEST_SUITE_END()
