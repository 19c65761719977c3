#include "solver/fit/least_squares.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "solver/base/error.hpp"

BOOST_AUTO_TEST_SUITE(fit_tests)

using namespace talus;

namespace {

/// y = a exp(-b x) at x = 0, 0.1, ..., with the given noise over its uncertainty.
FitModel decay(const std::vector<double>& noise, double a, double b, double uncertainty) {
  return [=](const std::vector<double>& p, const std::vector<std::size_t>& rows) {
    std::vector<double> found;
    for (const std::size_t row : rows) {
      const double x = 0.1 * static_cast<double>(row);
      found.push_back((p[0] * std::exp(-p[1] * x) - a * std::exp(-b * x)) / uncertainty - noise[row]);
    }
    return found;
  };
}

std::vector<double> normal_numbers(unsigned seed, std::size_t count) {
  std::mt19937_64 generator{seed};
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11U) + 0.5) * 0x1p-53; };
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i)
    numbers.push_back(std::sqrt(-2.0 * std::log(uniform())) * std::cos(6.283185307179586 * uniform()));
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_data_give_the_parameters) {
  const std::vector<double> none(20);
  for (const Spacing spacing : {Spacing::even, Spacing::logarithmic}) {
    const Fit found = fit({{0.1, 10.0, 1.0, spacing}, {0.01, 20.0, 10.0, spacing}}, decay(none, 2.5, 1.7, 0.1),
                          {.rows = 20, .samples = 50}, true);
    BOOST_TEST(found.values[0] == 2.5, boost::test_tools::tolerance(1e-8));
    BOOST_TEST(found.values[1] == 1.7, boost::test_tools::tolerance(1e-8));
    BOOST_TEST(found.sum < 1e-12);
    BOOST_TEST(!found.at_bound[0]);
    BOOST_TEST(!found.undetermined[1]);
    // Each sample has the same fit.
    BOOST_TEST(found.samples.size() == 50U);
    BOOST_TEST(found.intervals[0][1] - found.intervals[0][0] < 1e-6);
  }
}

// The covariance of a linear model, (J^T J)^-1: y = p0 + p1 x at x = -1, 0, 1, uncertainty 0.5.
BOOST_AUTO_TEST_CASE(standard_errors_of_a_line_are_exact) {
  const std::vector<double> measured{1.0, 2.5, 2.0};
  const FitModel line = [&](const std::vector<double>& p, const std::vector<std::size_t>& rows) {
    std::vector<double> found;
    for (const std::size_t row : rows)
      found.push_back((p[0] + p[1] * (static_cast<double>(row) - 1.0) - measured[row]) / 0.5);
    return found;
  };
  const std::vector<FitParameter> parameters{{-10.0, 10.0, 0.0}, {-10.0, 10.0, 0.0}};
  const Fit absolute = fit(parameters, line, {.rows = 3, .samples = 0}, true);
  BOOST_TEST(absolute.values[0] == 5.5 / 3.0, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(absolute.values[1] == 0.5, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(absolute.errors[0] == 0.5 / std::sqrt(3.0), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(absolute.errors[1] == 0.5 / std::sqrt(2.0), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::abs(absolute.correlation[0][1]) < 1e-9);
  BOOST_TEST(absolute.intervals.empty());
  // From the scatter: the deviations -1/3, 2/3, -1/3 have the variance 2/3 with one degree of freedom.
  const Fit relative = fit(parameters, line, {.rows = 3, .samples = 0}, false);
  BOOST_TEST(relative.errors[1] == std::sqrt(2.0 / 3.0 / 2.0), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(relative.degrees_of_freedom() == 1.0);
}

BOOST_AUTO_TEST_CASE(what_the_data_do_not_determine_is_named) {
  const FitModel sum = [](const std::vector<double>& p, const std::vector<std::size_t>& rows) {
    std::vector<double> found;
    for (const std::size_t row : rows)
      found.push_back(p[0] + p[1] - 3.0 + 0.01 * (row % 2 == 0 ? 1.0 : -1.0));
    return found;
  };
  const Fit found = fit({{0.0, 10.0, 1.0}, {0.0, 10.0, 1.0}, {0.0, 1.0, 0.5}}, sum, {.rows = 10, .samples = 0}, true);
  BOOST_TEST(found.values[0] + found.values[1] == 3.0, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(found.correlation[0][1] < -0.999);
  BOOST_TEST(found.undetermined[2]);
}

BOOST_AUTO_TEST_CASE(a_value_stays_within_its_bounds) {
  const std::vector<double> none(10);
  const Fit found =
      fit({{3.0, 10.0, 5.0}, {0.0, 5.0, 1.0}}, decay(none, 2.0, 1.0, 0.1), {.rows = 10, .samples = 20}, true);
  BOOST_TEST(found.values[0] == 3.0);
  BOOST_TEST(found.at_bound[0]);
  BOOST_TEST(!found.at_bound[1]);
  for (const std::vector<double>& sample : found.samples)
    BOOST_TEST(sample[0] >= 3.0);
}

BOOST_AUTO_TEST_CASE(samples_depend_on_the_seed_alone) {
  const std::vector<double> noise = normal_numbers(5, 20);
  const std::vector<FitParameter> parameters{{0.1, 10.0, 1.0}, {0.01, 20.0, 10.0, Spacing::logarithmic}};
  const FitModel model = decay(noise, 2.5, 1.7, 0.05);
  const auto samples = [&](std::int64_t seed) {
    return fit(parameters, model, {.rows = 20, .samples = 30, .seed = seed}, true).samples;
  };
  BOOST_TEST((samples(1) == samples(1)));
  BOOST_TEST((samples(1) != samples(2)));
}

BOOST_AUTO_TEST_CASE(a_model_without_results_is_refused) {
  const FitModel none = [](const std::vector<double>&, const std::vector<std::size_t>& rows) {
    return std::vector<double>(rows.size(), std::nan(""));
  };
  BOOST_CHECK_THROW(static_cast<void>(fit({{0.0, 1.0, 0.5}}, none, {.rows = 5}, true)), InputError);
  const std::vector<double> two(2);
  BOOST_CHECK_THROW(
      static_cast<void>(fit({{0.1, 10.0, 1.0}, {0.01, 20.0, 10.0}}, decay(two, 1.0, 1.0, 1.0), {.rows = 2}, true)),
      InputError);
  // Where a part of the range has no result, the search continues beside it.
  const FitModel part = [](const std::vector<double>& p, const std::vector<std::size_t>& rows) {
    return std::vector<double>(rows.size(), p[0] > 0.6 ? std::nan("") : p[0] - 0.4);
  };
  BOOST_TEST(fit({{0.0, 1.0, 0.9}}, part, {.rows = 5}, true).values[0] == 0.4, boost::test_tools::tolerance(1e-6));
  struct Stop {};
  const FitModel stopped = [count = 0](const std::vector<double>& p, const std::vector<std::size_t>& rows) mutable {
    if (++count > 30) throw Stop{};
    return std::vector<double>(rows.size(), p[0] - 0.3);
  };
  BOOST_CHECK_THROW(static_cast<void>(fit({{0.0, 1.0, 0.9}}, stopped, {.rows = 5}, true)), Stop);
}

BOOST_AUTO_TEST_SUITE_END()
