#include "verification/reference/integration/amplification.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(amplification_tests)

namespace ref = talus::verification::reference;
using ref::Scheme;

namespace {

double first_limit(Scheme scheme, double xi, double maximum) {
  const auto all = ref::limits(scheme, xi, maximum);
  return all.empty() ? std::numeric_limits<double>::quiet_NaN() : all.front();
}

/// Logarithm of the largest modulus, from a run of the eight-value Adams pair on y' = lambda y with coefficients as
/// printed in tables.
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
    // At small xi its growth crosses zero so slowly that the limit is determined only to 1e-10/(2 xi^2).
    const double euler = xi < 1.0 ? 2.0 * xi : 2.0 / (xi + std::sqrt(xi * xi - 1.0));
    BOOST_TEST(first_limit(Scheme::euler, xi, 2.0 * euler) == euler,
               boost::test_tools::tolerance(1e-6 + 1e-10 / (xi * xi)));
  }
}

BOOST_AUTO_TEST_CASE(growth_of_a_leapfrog_beyond_its_limit) {
  // A real pair around -1: 2 cosh(g) = eta^2 - 2.
  BOOST_TEST(ref::ln_growth(Scheme::half_step, 2.02, 0.0) == std::acosh(0.5 * 2.02 * 2.02 - 1.0),
             boost::test_tools::tolerance(1e-12));
  // A complex pair below it: the determinant is 1 - 2 xi eta.
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

BOOST_AUTO_TEST_CASE(euler_and_taylor_grow_by_their_determinants_where_they_turn) {
  // [[1, 1], [-k, 1 - d]] and [[1 - k/2, 1 - d/2], [-k, 1 - d]] in q and h v, k = eta^2, d = 2 xi eta.
  for (const double xi : {0.0, 0.1, 0.4}) {
    for (const double eta : {1e-3, 0.05, 0.3, 0.9}) {
      const double k = eta * eta, d = 2.0 * xi * eta;
      BOOST_TEST(std::abs(ref::ln_growth(Scheme::euler, eta, xi) - 0.5 * std::log1p(k - d)) < 1e-15);
      BOOST_TEST(std::abs(ref::ln_growth(Scheme::taylor, eta, xi) - 0.5 * std::log1p(0.5 * k - d)) < 1e-15);
    }
  }
  // Limit of taylor: the determinant is one up to xi = 1/2; beyond, an eigenvalue is -1.
  for (const double xi : {0.1, 0.4, 0.49, 0.51, 1.0, 1.5, 2.0}) {
    BOOST_TEST(first_limit(Scheme::taylor, xi, 4.0) == (xi < 0.5 ? 4.0 * xi : 1.0 / xi),
               boost::test_tools::tolerance(1e-7));
  }
  BOOST_TEST(ref::ln_growth(Scheme::euler, 1e-3, 0.0) > 0.0);
  BOOST_TEST(ref::ln_growth(Scheme::taylor, 1e-3, 0.0) > 0.0);
}

namespace {

/// SRKN_6^b as tabulated with all its digits, kicks b and drifts a alternating.
constexpr std::array kicks{0.082984406417405200, 0.39630980149836800, -0.039056304922348600, 0.1195241940131508};
constexpr std::array drifts{0.24529895718427100, 0.60487266571108000, -0.35017162289535100};

/// Half the trace of an undamped step: 1 + 2 q_v v_q, from the matrix ((q_q, q_v), (v_q, v_v)) of half a step, because
/// the other half is its mirror image.
double half_trace(double eta) {
  const double k = eta * eta;
  double qq = 1.0, qv = 0.0, vq = 0.0, vv = 1.0;
  for (std::size_t i = 0; i < drifts.size(); ++i) {
    vq -= kicks[i] * k * qq, vv -= kicks[i] * k * qv;
    qq += drifts[i] * vq, qv += drifts[i] * vv;
  }
  vq -= 0.5 * kicks[3] * k * qq, vv -= 0.5 * kicks[3] * k * qv;
  return 1.0 + 2.0 * qv * vq;
}

}  // namespace

BOOST_AUTO_TEST_CASE(tabulated_kicks_and_drifts_hold_the_conditions_of_order_four) {
  // Conditions for Nystroem methods, with sums over kicks at the times c: b = 1, b c = 1/2, b c^2 = 1/3, b_i b_j (c_i -
  // c_j) = 1/6, i > j; order four follows by symmetry.
  const std::array b{kicks[0], kicks[1], kicks[2], kicks[3], kicks[2], kicks[1], kicks[0]};
  const std::array a{drifts[0], drifts[1], drifts[2], drifts[2], drifts[1], drifts[0]};
  double time = 0.0, once = 0.0, squared = 0.0, weights = 0.0, twice = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    twice += b[i] * (time * weights - once);
    weights += b[i], once += b[i] * time, squared += b[i] * time * time;
    if (i < a.size()) time += a[i];
  }
  BOOST_TEST(std::abs(time - 1.0) < 1e-14);
  BOOST_TEST(std::abs(weights - 1.0) < 1e-14);
  BOOST_TEST(std::abs(once - 1.0 / 2.0) < 1e-14);
  BOOST_TEST(std::abs(squared - 1.0 / 3.0) < 1e-14);
  BOOST_TEST(std::abs(twice - 1.0 / 6.0) < 1e-14);
}

BOOST_AUTO_TEST_CASE(blanes_and_moans_method_grows_by_its_trace_where_nothing_damps) {
  for (const double eta : {0.3, 1.0, 2.0, 3.0, 4.0, 5.0}) {
    BOOST_TEST(std::abs(half_trace(eta)) < 1.0);
    BOOST_TEST(std::abs(ref::ln_growth(Scheme::blanes_moan4, eta, 0.0)) < 1e-13);
  }
  for (const double eta : {3.1663, 5.1, 6.0, 7.0}) {
    BOOST_TEST(std::abs(half_trace(eta)) > 1.0);
    BOOST_TEST(ref::ln_growth(Scheme::blanes_moan4, eta, 0.0) == std::acosh(std::abs(half_trace(eta))),
               boost::test_tools::tolerance(1e-9));
  }
  // A narrow window of growth, then permanent growth (up to 7.6).
  const std::vector<double> ends = ref::limits(Scheme::blanes_moan4, 0.0, 7.0, 5000);
  BOOST_REQUIRE(ends.size() == 3);
  for (const double end : ends)
    BOOST_TEST(std::abs(half_trace(end)) == 1.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(ref::limits(Scheme::blanes_moan4, 0.0, 7.0, 70).size() == 1);  // the window is missed
}

BOOST_AUTO_TEST_CASE(blanes_and_moans_method_dies_by_its_determinant_where_it_turns) {
  // A kick removes b d of the velocity before it; the last kick of a step and the first of the next are one.
  for (const double xi : {0.02, 0.1, 0.2}) {
    for (const double eta : {0.1, 0.7, 1.5}) {
      const double d = 2.0 * xi * eta;
      const double ends = 1.0 - 2.0 * kicks[0] * d, middle = 1.0 - kicks[3] * d;
      const double between = (1.0 - kicks[1] * d) * (1.0 - kicks[2] * d);
      BOOST_TEST(ref::ln_growth(Scheme::blanes_moan4, eta, xi) == 0.5 * std::log(ends * middle * between * between),
                 boost::test_tools::tolerance(1e-11));
    }
  }
}

BOOST_AUTO_TEST_CASE(multipliers_of_a_made_up_motion_are_found) {
  // Three eigenvalues: a complex pair of modulus 0.8 and a real one of 0.95, mixed in both numbers.
  ref::Motion states;
  for (int n = 0; n < 30; ++n) {
    const double pair = std::pow(0.8, n), real = std::pow(-0.95, n);
    states.push_back({pair * std::cos(1.1 * n) + 0.3 * real, pair * std::sin(1.1 * n) - 0.7 * real});
  }
  BOOST_TEST(std::abs(ref::ln_multiplier({&states, 1}, 3, 1e-15) - std::log(0.95)) < 1e-9);
  ref::Motion pair;
  for (int n = 0; n < 10; ++n)
    pair.push_back({1e-9 * std::pow(3.0, n) * std::cos(0.4 * n), 1e-9 * std::pow(3.0, n) * std::sin(0.4 * n + 0.2)});
  BOOST_TEST(std::abs(ref::ln_multiplier({&pair, 1}, 2, 1e-22) - std::log(3.0)) < 1e-9);
  const ref::Motion two{pair[0], pair[1]}, others{pair[4], pair[5]};
  BOOST_TEST(std::isnan(ref::ln_multiplier({&two, 1}, 2, 1e-22)));
  // Two runs of one step each give as much information as one run of two steps.
  const std::array both{two, others};
  BOOST_TEST(std::abs(ref::ln_multiplier(both, 2, 1e-22) - std::log(3.0)) < 1e-9);
  // Only noise.
  BOOST_TEST(std::isnan(ref::ln_multiplier(both, 2, 1.0)));
}

BOOST_AUTO_TEST_SUITE_END()
