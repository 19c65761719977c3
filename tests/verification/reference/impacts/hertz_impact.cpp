#include "verification/reference/impacts/hertz_impact.hpp"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

#include "verification/reference/impacts/restitution.hpp"
#include "verification/reference/mathematics/high_precision.hpp"
#include "verification/reference/mathematics/trajectory.hpp"

BOOST_AUTO_TEST_SUITE(hertz_impact_tests)

namespace ref = talus::verification::reference;
using ref::EndRule;

// The integral 2 int_0^1 ds/sqrt(1 - s^(5/2)), with 1 - s = r^2 to remove the singularity, by the plain midpoint rule:
// its error falls with the square of the spacing.
BOOST_AUTO_TEST_CASE(time_factor_is_the_integral) {
  const auto midpoints = [](int n) {
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
      const double r = (i + 0.5) / n;
      sum += 4.0 * r / std::sqrt(-std::expm1(2.5 * std::log1p(-r * r))) / n;
    }
    return sum;
  };
  const double coarse = midpoints(20000), fine = midpoints(40000);
  BOOST_TEST((4.0 * fine - coarse) / 3.0 == ref::hertz_time_factor(), boost::test_tools::tolerance(1e-10));
  BOOST_TEST(std::abs(ref::hertz_time_factor() - 2.9432) < 1e-4);  // value in textbooks
}

// The equation itself by tight integration, starting slightly after first contact. The powers 3/2 and 1/4 reduce the
// integrator's order there: the measured errors are 3e-10 and 2e-9 (a wrong constant would cause a per cent).
BOOST_AUTO_TEST_CASE(events_match_a_tight_integration) {
  const double k = 3.0, m = 0.4, v = 1.7;
  for (const double xi : {0.0, 0.2, 0.6}) {
    for (const EndRule end : {EndRule::attractive, EndRule::clamped}) {
      const ref::HertzEvents found = ref::hertz_events({k, xi, m, v}, end);
      const long double c = 2.0L * xi * std::sqrt(1.25L * k * m);
      const auto force = [=](const ref::Coordinates& y) {
        const long double x = std::max(y[0], 0.0L);
        return k * x * std::sqrt(x) + c * std::sqrt(std::sqrt(x)) * y[1];
      };
      const auto rates = [=](const ref::Coordinates& y, ref::Coordinates& dydt) {
        dydt[0] = y[1];
        dydt[1] = -force(y) / m;
      };
      // After first contact: x' = v - (4/5)(c/m) x^(5/4) from the first term of the law, neglecting its square.
      const long double x = 1e-8L;
      ref::Trajectory path(rates, {x, v - 0.8L * c / m * std::pow(x, 1.25L)}, x / v, 1e-3L);
      const ref::Guard turn = [](const ref::Coordinates& y) { return y[1]; };
      BOOST_REQUIRE(path.advance_until(std::array{turn}, 10.0L).has_value());
      BOOST_TEST(static_cast<double>(path.coordinates()[0]) == found.largest_depth, boost::test_tools::tolerance(1e-9));
      const ref::Guard ends = [=](const ref::Coordinates& y) {
        return end == EndRule::clamped ? force(y) : y[0] - 1e-8L;
      };
      if (end == EndRule::clamped && xi == 0.0) continue;  // its force is that of the attractive rule
      BOOST_REQUIRE(path.advance_until(std::array{ends}, 10.0L).has_value());
      const double left = end == EndRule::clamped ? 0.0 : 1e-8 / (found.restitution * v);
      BOOST_TEST(static_cast<double>(path.time()) + left == found.contact_time, boost::test_tools::tolerance(5e-9));
      BOOST_TEST(static_cast<double>(-path.coordinates()[1]) / v == found.restitution,
                 boost::test_tools::tolerance(5e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(without_damping_energy_gives_the_depth) {
  const double k = 3.0, m = 0.4, v = 1.7;
  const ref::HertzEvents found = ref::hertz_events({k, 0.0, m, v}, EndRule::clamped);
  BOOST_TEST(0.4 * k * std::pow(found.largest_depth, 2.5) == 0.5 * m * v * v, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(found.restitution == 1.0);
  BOOST_TEST(found.contact_time == ref::hertz_events({k, 0.0, m, v}, EndRule::attractive).contact_time);
  // A dashpot with hardly any damping: quadrature compared with the closed form.
  const ref::HertzEvents weak = ref::hertz_events({k, 1e-12, m, v}, EndRule::attractive);
  BOOST_TEST(weak.contact_time == found.contact_time, boost::test_tools::tolerance(1e-11));
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::hertz_events({0.0, 0.0, 1.0, 1.0}, EndRule::clamped), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::hertz_events({1.0, 1.0, 1.0, 1.0}, EndRule::clamped), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
