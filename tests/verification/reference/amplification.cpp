#define BOOST_TEST_MODULE reference_amplification
#include "verification/reference/amplification.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <vector>

namespace ref = talus::verification::reference;
using ref::Scheme;

namespace {

double first_limit(Scheme scheme, double xi, double most) {
  const auto all = ref::limits(scheme, xi, most);
  return all.empty() ? std::numeric_limits<double>::quiet_NaN() : all.front();
}

/// The largest modulus by running Adams' eight-value pair, coefficients as printed in tables, on y' = lambda y.
double ln_growth_of_run(std::complex<double> z) {
  const double b[] = {434241, -1152169, 2183877, -2664477, 2102243, -1041723, 295767, -36799};
  const double m[] = {36799, 139849, -121797, 123133, -88547, 41499, -11351, 1375};
  std::array<std::complex<double>, 8> y{-0.6, -0.5, -0.3, 0.2, 0.4, 0.7, 0.9, 1.0};  // newest first
  double gathered = 0.0;
  for (int n = 0; n < 4000; ++n) {
    std::complex<double> predicted = y[0], corrected = y[0];
    for (std::size_t j = 0; j < 8; ++j)
      predicted += z * b[j] / 120960.0 * y[j];
    corrected += z * m[0] / 120960.0 * predicted;
    for (std::size_t j = 1; j < 8; ++j)
      corrected += z * m[j] / 120960.0 * y[j - 1];
    const double size = std::abs(corrected);
    if (n >= 1000) gathered += std::log(size);
    std::rotate(y.rbegin(), y.rbegin() + 1, y.rend());
    y[0] = corrected;
    for (auto& value : y)
      value /= size;
  }
  return gathered / 3000.0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(leapfrogs_have_the_limits_of_their_characteristic_polynomials) {
  // lambda = -1 of each quadratic, or a complex pair of modulus one.
  for (const double xi : {0.001, 0.05, 0.1, 0.4, 1.0, 2.0}) {
    const double s = std::sqrt(1.0 + xi * xi);
    const auto near = boost::test_tools::tolerance(1e-6);
    BOOST_TEST(first_limit(Scheme::half_step, xi, 5.0) == 2.0 * (s - xi), near);
    BOOST_TEST(first_limit(Scheme::average, xi, 5.0) == 2.0, near);
    BOOST_TEST(first_limit(Scheme::implicit, xi, 12.0) == 2.0 * (s + xi), near);
    BOOST_TEST(first_limit(Scheme::late, xi, 5.0) == s - xi, near);
    BOOST_TEST(first_limit(Scheme::verlet_old, xi, 5.0) == std::sqrt(xi * xi + 2.0) - xi, near);
    BOOST_TEST(first_limit(Scheme::verlet_predicted, xi, 5.0) == 2.0 * (std::sqrt(1.0 + 4.0 * xi * xi) - 2.0 * xi),
               near);
    // Its growth passes nought so flatly at small xi that the limit is found to 1e-10/(2 xi^2) only.
    const double euler = xi < 1.0 ? 2.0 * xi : 2.0 / (xi + std::sqrt(xi * xi - 1.0));
    BOOST_TEST(first_limit(Scheme::euler, xi, 2.0 * euler) == euler,
               boost::test_tools::tolerance(1e-6 + 1e-10 / (xi * xi)));
  }
}

BOOST_AUTO_TEST_CASE(growth_of_a_leapfrog_beyond_its_limit) {
  // Real pair around -1: 2 cosh(g) = eta^2 - 2.
  BOOST_TEST(ref::ln_growth(Scheme::half_step, 2.02, 0.0) == std::acosh(0.5 * 2.02 * 2.02 - 1.0),
             boost::test_tools::tolerance(1e-12));
  // Complex pair below it: the determinant is 1 - 2 xi eta.
  BOOST_TEST(ref::ln_growth(Scheme::half_step, 0.5, 0.1) == 0.5 * std::log(0.9), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(runge_kutta_polynomials_are_those_of_the_exponential_up_to_their_order) {
  struct Known {
    Scheme scheme;
    std::size_t order;
  };
  for (const Known known : {Known{Scheme::euler, 1}, Known{Scheme::rk4, 4}, Known{Scheme::dopri5, 5},
                            Known{Scheme::cash_karp54, 5}, Known{Scheme::fehlberg78, 8}}) {
    const auto c = ref::stability_polynomial(known.scheme);
    double factorial = 1.0;
    for (std::size_t n = 1; n <= known.order; ++n) {
      factorial *= static_cast<double>(n);
      BOOST_TEST(c[n] * factorial == 1.0, boost::test_tools::tolerance(1e-11));
    }
    if (c.size() > known.order + 1)
      BOOST_TEST(std::abs(c[known.order + 1] * factorial * static_cast<double>(known.order + 1) - 1.0) > 1e-3);
  }
  BOOST_TEST(ref::stability_polynomial(Scheme::dopri5)[6] == 1.0 / 600.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(ref::stability_polynomial(Scheme::cash_karp54)[6] == 1.0 / 800.0, boost::test_tools::tolerance(1e-12));
  BOOST_CHECK_THROW((void)ref::stability_polynomial(Scheme::late), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(limits_of_the_classical_runge_kutta_method) {
  BOOST_TEST(first_limit(Scheme::rk4, 0.0, 4.0) == 2.0 * std::sqrt(2.0), boost::test_tools::tolerance(1e-6));
  // The real interval ends where z^3/24 + z^2/6 + z/2 + 1 = 0.
  const double end = first_limit(Scheme::rk4, 1.0, 4.0);
  BOOST_TEST(std::abs(1.0 - end / 2.0 + end * end / 6.0 - end * end * end / 24.0) < 1e-6);
}

BOOST_AUTO_TEST_CASE(adams_eigenvalue_is_the_growth_of_a_run) {
  for (const std::complex<double> z : {std::complex<double>{-0.2, 0.6}, {-1.0, 0.0}, {-0.4, 1.1}, {0.0, 0.9}})
    BOOST_TEST(std::abs(ln_growth_of_run(z) - ref::ln_growth(Scheme::abm8, std::abs(z), -z.real() / std::abs(z))) <
               1e-3);
}

BOOST_AUTO_TEST_CASE(multipliers_of_a_made_up_motion_are_found) {
  // Three eigenvalues: a complex pair of modulus .8 and a real one of .95, mixed in both numbers.
  std::vector<std::array<double, 2>> states;
  for (int n = 0; n < 30; ++n) {
    const double pair = std::pow(0.8, n), real = std::pow(-0.95, n);
    states.push_back({pair * std::cos(1.1 * n) + 0.3 * real, pair * std::sin(1.1 * n) - 0.7 * real});
  }
  BOOST_TEST(std::abs(ref::ln_multiplier(states, 3, 1e-15) - std::log(0.95)) < 1e-9);
  std::vector<std::array<double, 2>> pair;
  for (int n = 0; n < 10; ++n)
    pair.push_back({1e-9 * std::pow(3.0, n) * std::cos(0.4 * n), 1e-9 * std::pow(3.0, n) * std::sin(0.4 * n + 0.2)});
  BOOST_TEST(std::abs(ref::ln_multiplier(pair, 2, 1e-22) - std::log(3.0)) < 1e-9);
  BOOST_TEST(std::isnan(ref::ln_multiplier({pair.data(), 2}, 2, 1e-22)));
}
