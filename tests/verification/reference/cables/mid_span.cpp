#include "verification/reference/cables/mid_span.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "verification/reference/mathematics/trajectory.hpp"

BOOST_AUTO_TEST_SUITE(mid_span_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr ref::MidSpan span{8.0, 2.0, 0.5};

// Four times the time from rest at A to the middle, by tight integration to an event.
template <class Force>
double integrated_period(double amplitude, const Force& force) {
  const auto rates = [&](const ref::Coordinates& y, ref::Coordinates& dydt) {
    dydt[0] = y[1];
    dydt[1] = -force(y[0]) / static_cast<long double>(span.mass);
  };
  const ref::Guard middle = [](const ref::Coordinates& y) { return y[0]; };
  ref::Trajectory path(rates, {amplitude, 0.0L}, 0.0L, 0.01L / amplitude);
  BOOST_REQUIRE(path.advance_until(std::array{middle}, 100.0L / amplitude));
  return 4.0 * static_cast<double>(path.time());
}

}  // namespace

BOOST_AUTO_TEST_CASE(force_is_the_textbook_one_and_cubic_in_the_limit) {
  for (const double w : {0.5, -1.0, 3.0, 20.0}) {
    const double textbook = 2.0 * span.stiffness * (1.0 - 2.0 / std::sqrt(4.0 + w * w)) * w;
    BOOST_TEST(ref::mid_span_force(span, w) == textbook, boost::test_tools::tolerance(100 * eps));
  }
  const double cubic = 8.0 * 1e-12 / 4.0;
  BOOST_TEST(ref::mid_span_force(span, 1e-4) == cubic * (1.0 - 0.75 * 2.5e-9), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(periods_are_those_integrated) {
  for (const double a : {0.1, 1.0, 5.0}) {
    const double exact = integrated_period(a, [](long double x) {
      const long double whole = std::sqrt(4.0L + x * x);
      return 16.0L * x * x * x / (whole * (whole + 2.0L));
    });
    BOOST_TEST(ref::mid_span_period(span, a) == exact, boost::test_tools::tolerance(1e-14));
    const double cubic = integrated_period(a, [](long double x) { return 2.0L * x * x * x; });
    BOOST_TEST(ref::cubic_period(span, a) == cubic, boost::test_tools::tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(amplitude_lengthens_the_period) {
  for (const double a : {0.01, 0.02}) {
    const double found = ref::mid_span_period(span, a) / ref::cubic_period(span, a) - 1.0;
    // The next term is (A/L)^2 times this one, 1e-4.
    BOOST_TEST(found == ref::longer_by_amplitude(span, a), boost::test_tools::tolerance(1e-4));
  }
}

BOOST_AUTO_TEST_CASE(steps_shorten_the_period_of_the_cubic_oscillator) {
  // Velocity Verlet written out, up to the first passage, which is interpolated with v = const (x'' = x''' = 0).
  const double h = ref::cubic_period(span, 1.0) / 2000.3;
  double x = 1.0, v = 0.0, t = 0.0;
  for (;; t += h) {
    const double half = v - h / 2.0 * 4.0 * x * x * x;
    const double next = x + h * half;
    if (next <= 0.0) {
      t += h * x / (x - next);
      break;
    }
    x = next;
    v = half - h / 2.0 * 4.0 * x * x * x;
  }
  const double found = 4.0 * t / ref::cubic_period(span, 1.0) - 1.0;
  BOOST_TEST(found == ref::longer_by_steps(span, 1.0, h), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
