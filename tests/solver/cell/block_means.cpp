#include "solver/cell/block_means.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(block_means_tests)

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
  // Samples beyond the end belong to the last block.
  means.add(4.0, 1.0, std::array{7.0, 30.0});
  BOOST_TEST(means.block_mean(3, 0) == 7.0);
}

BOOST_AUTO_TEST_CASE(undefined_means_are_not_numbers) {
  BlockMeans means{2, 4.0, 4};
  BOOST_TEST(std::isnan(means.estimate(0, 0).value));
  for (const double t : {0.5, 1.5, 2.5, 3.5})
    means.add(t, 1.0, std::array{t > 3.0 ? 1.0 : 0.0, 0.0});
  BOOST_TEST(std::isnan(means.ratio(1, 1, 0).value));
  BOOST_TEST(std::isnan(means.ratio(0, 1, 0).value));
  BOOST_TEST(means.ratio(1, 1, 0).error == 0.0);
  BOOST_TEST(means.ratio(1, 0, 0).value == 0.0);
  // Three of four blocks have no denominator: resamples that consist only of those do not count.
  BOOST_TEST(std::isfinite(means.ratio(0, 0, 0).error));
}

namespace {

/// First-order autoregression.
std::vector<double> autoregression(double a, std::size_t count, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> series;
  double x = normal(random) / std::sqrt(1.0 - a * a);
  for (std::size_t n = 0; n < count; ++n, x = a * x + normal(random))
    series.push_back(x);
  return series;
}

}  // namespace

BOOST_AUTO_TEST_CASE(blocks_are_as_long_as_the_series_remembers) {
  // (2 G^2/D)^(1/3) n^(1/3) with G/g(0) = 2 a/(1 - a^2), D = 4/3 g(0)^2 (Politis & White 2004).
  std::mt19937_64 random{3};
  for (const double a : {0.3, 0.7, -0.5}) {
    const std::size_t count = 20000;
    const double exact = std::cbrt(1.5 * std::pow(2.0 * a / (1.0 - a * a), 2.0) * static_cast<double>(count));
    BOOST_TEST(static_cast<double>(block_length(autoregression(a, count, random))) == exact,
               boost::test_tools::tolerance(0.15));
  }
  BOOST_TEST(block_length(autoregression(0.0, 20000, random)) < 10U);
  BOOST_TEST(block_length(autoregression(0.999, 75, random)) <= 25U);
  BOOST_TEST(block_length(std::vector<double>(75, 1.5)) == 1U);
  BOOST_TEST(block_length(std::vector<double>{1.0, 2.0}) == 1U);
}

BOOST_AUTO_TEST_CASE(errors_of_what_is_made_of_means) {
  // Error of the square of a mean, from its slope at the mean; no error for a value that is the same in all blocks.
  std::mt19937_64 random{5};
  BlockMeans means{2, 400.0, 400};
  double t = 0.5;
  for (const double x : autoregression(0.5, 400, random))
    means.add(t, 1.0, std::array{x + 100.0, 2.0}), t += 1.0;
  const Estimate mean = means.estimate(0, 0);
  const Estimate square = means.estimate(0, [](const auto& of) { return of(0) * of(0); });
  BOOST_TEST(square.value == mean.value * mean.value);
  BOOST_TEST(square.error == 2.0 * mean.value * mean.error, boost::test_tools::tolerance(0.01));
  BOOST_TEST(means.ratio(0, 1, 0).error == 0.5 * mean.error, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(means.estimate(1, 0).error < 1e-12);
}

BOOST_AUTO_TEST_CASE(errors_are_those_of_correlated_series) {
  // First-order autoregression: the mean of n values has the variance s^2/n (1 + a)/(1 - a) for long series.
  for (const double a : {0.0, 0.6}) {
    std::mt19937_64 random{7};
    std::normal_distribution<double> normal;
    const int series = 200;
    double squares = 0.0, estimated = 0.0;
    for (int s = 0; s < series; ++s) {
      BlockMeans means{1, 125.0, 125};
      double x = normal(random) / std::sqrt(1.0 - a * a);
      for (int n = 0; n < 1000; ++n) {
        means.add((n + 0.5) / 8.0, 0.125, std::array{x});
        x = a * x + normal(random);
      }
      const Estimate estimate = means.estimate(0, 25);
      squares += estimate.value * estimate.value / series;
      estimated += estimate.error / series;
    }
    // 200 series determine a standard deviation to 5 %; resampling of whole blocks underestimates it by a few per cent.
    BOOST_TEST(estimated == std::sqrt(squares), boost::test_tools::tolerance(0.2));
    BOOST_TEST(estimated == std::sqrt(1.0 / (1.0 - a) / (1.0 - a) / 800.0), boost::test_tools::tolerance(0.15));
  }
}

BOOST_AUTO_TEST_SUITE_END()
