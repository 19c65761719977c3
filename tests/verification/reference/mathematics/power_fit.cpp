#include "verification/reference/mathematics/power_fit.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(power_fit_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr double limit = 0.11, factor = 0.5, power = 0.5, noise = 2e-3;

std::vector<ref::FitPoint> points_of(double linear) {
  std::vector<ref::FitPoint> points;
  for (const double x : {3e-3, 1e-2, 2e-2, 5e-2, 1e-1, 2e-1})
    points.push_back({x, 0.0, limit + factor * std::pow(x, power) + linear * x, noise});
  return points;
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_points_give_their_coefficients) {
  const ref::PowerFit free = ref::fit_power(points_of(0.0));
  BOOST_TEST(free.limit == limit, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(free.factor == factor, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(free.power == power, boost::test_tools::tolerance(1e-12));
  const ref::PowerFit given = ref::fit_given_power(points_of(0.0), power);
  BOOST_TEST(given.limit == limit, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(given.at(0.04) == limit + factor * 0.2, boost::test_tools::tolerance(1e-12));
  const ref::PowerFit corrected = ref::fit_corrected_power(points_of(-0.3), power);
  BOOST_TEST(corrected.limit == limit, boost::test_tools::tolerance(1e-11));
  BOOST_TEST(corrected.linear == -0.3, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(corrected.at(0.04) == limit + factor * 0.2 - 0.3 * 0.04, boost::test_tools::tolerance(1e-11));
  BOOST_TEST(ref::fit_given_power(points_of(-0.3), power).chi_squared > 1.0);
}

BOOST_AUTO_TEST_CASE(errors_in_x_weigh_as_the_slope_makes_them) {
  // For a straight line, the same points with the errors moved from y to x, divided by the slope, have the same fit.
  std::mt19937 random{5};
  std::normal_distribution<double> gauss{0.0, 1.0};
  std::vector<ref::FitPoint> in_y, in_x;
  for (int k = 1; k <= 6; ++k) {
    const double x = 0.05 * k, error = 1e-3 * k;
    in_y.push_back({x, 0.0, 0.2 + 2.0 * x + error * gauss(random), error});
    in_x.push_back(in_y.back());
  }
  const ref::PowerFit fit = ref::fit_given_power(in_y, 1.0);
  for (ref::FitPoint& point : in_x)
    point.x_error = point.y_error / fit.factor, point.y_error = 0.0;
  const ref::PowerFit other = ref::fit_given_power(in_x, 1.0);
  BOOST_TEST(other.limit == fit.limit, boost::test_tools::tolerance(1e-11));
  BOOST_TEST(other.chi_squared == fit.chi_squared, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(errors_show_how_far_the_limit_scatters) {
  // A Gaussian number is within its standard error 68 times in a hundred. For 200 fits this fraction has a standard
  // deviation of 0.033. If the power is fitted, errors are the larger of two sides of a curved fit, and more may be
  // within.
  std::mt19937 random{7};
  std::normal_distribution<double> gauss{0.0, noise};
  int within = 0, within_given = 0;
  double chi_squared = 0.0;
  constexpr int draws = 200;
  for (int draw = 0; draw < draws; ++draw) {
    auto points = points_of(0.0);
    for (ref::FitPoint& point : points)
      point.y += gauss(random);
    const ref::PowerFit fit = ref::fit_power(points);
    within += std::abs(fit.limit - limit) <= fit.limit_error ? 1 : 0;
    chi_squared += fit.chi_squared;
    const ref::PowerFit given = ref::fit_given_power(points, power);
    within_given += std::abs(given.limit - limit) <= given.limit_error ? 1 : 0;
  }
  BOOST_TEST(within_given > 0.58 * draws);
  BOOST_TEST(within_given < 0.78 * draws);
  BOOST_TEST(within > 0.6 * draws);
  BOOST_TEST(within < 0.85 * draws);
  // Six points minus three coefficients; the standard deviation of the mean of 200 is sqrt(2 * 3/200) = 0.17.
  BOOST_TEST(chi_squared / draws == 3.0, boost::test_tools::tolerance(0.17));
}

BOOST_AUTO_TEST_CASE(chi_squared_of_two_is_exponential) {
  BOOST_TEST(ref::rare_chi_squared(2, 1e-3) == -2.0 * std::log(1e-3), boost::test_tools::tolerance(1e-12));
  // With one degree of freedom it is the square of a Gaussian number.
  BOOST_TEST(ref::rare_chi_squared(1, std::erfc(3.0 / std::sqrt(2.0))) == 9.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(too_few_points_are_refused) {
  const auto all = points_of(0.0);
  const std::vector<ref::FitPoint> few{all.begin(), all.begin() + 3};
  BOOST_CHECK_THROW((void)ref::fit_power(few), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::fit_corrected_power(few, power), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
