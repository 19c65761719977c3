#define BOOST_TEST_MODULE block_means
#include "solver/granular/block_means.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

using namespace talus;

BOOST_AUTO_TEST_CASE(means_are_weighted_by_time) {
  BlockMeans means{2, 4.0, 4};
  means.add(0.5, 1.0, std::array{1.0, 10.0});
  means.add(1.5, 2.0, std::array{4.0, 20.0});
  means.add(3.9, 1.0, std::array{7.0, 30.0});
  BOOST_TEST(means.mean(0, 0, 4) == 4.0);
  BOOST_TEST(means.mean(1, 1, 4) == 70.0 / 3.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(means.block_mean(1, 0) == 4.0);
  BOOST_TEST(means.block_mean(2, 0) == 0.0);
  BOOST_TEST(means.ratio(1, 0, 0).value == 5.0);
  // Beyond the end belongs to the last block.
  means.add(4.0, 1.0, std::array{7.0, 30.0});
  BOOST_TEST(means.block_mean(3, 0) == 7.0);
}

BOOST_AUTO_TEST_CASE(errors_are_those_of_correlated_series) {
  // First-order autoregression: the mean of n values has the variance s^2/n (1 + a)/(1 - a) for long series.
  for (const double a : {0.0, 0.6}) {
    std::mt19937_64 random{7};
    std::normal_distribution<double> normal;
    const int series = 200;
    double squares = 0.0, told = 0.0;
    for (int s = 0; s < series; ++s) {
      BlockMeans means{1, 125.0, 125};
      double x = normal(random) / std::sqrt(1.0 - a * a);
      for (int n = 0; n < 1000; ++n) {
        means.add((n + 0.5) / 8.0, 0.125, std::array{x});
        x = a * x + normal(random);
      }
      const Estimate estimate = means.estimate(0, 25);
      squares += estimate.value * estimate.value / series;
      told += estimate.error / series;
    }
    // 200 series tell a standard deviation to 5 %; blocks that are drawn whole tell a few per cent too little.
    BOOST_TEST(told == std::sqrt(squares), boost::test_tools::tolerance(0.2));
    BOOST_TEST(told == std::sqrt(1.0 / (1.0 - a) / (1.0 - a) / 800.0), boost::test_tools::tolerance(0.15));
  }
}
