#define BOOST_TEST_MODULE reference_rounded_swing
#include "verification/reference/rounded_swing.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <initializer_list>

namespace ref = talus::verification::reference;
using ref::Scalar;
using ref::SwingMethod;

BOOST_AUTO_TEST_CASE(closed_forms_are_those_of_their_recurrences) {
  // 113 bits leave some 1e-34 a step: the two ways agree far below a double's last digit.
  for (const SwingMethod method : {SwingMethod::verlet, SwingMethod::runge_kutta}) {
    for (const double h : {0.5, 0.1, 0.013}) {
      for (const long n : {1L, 2L, 17L, 500L})
        BOOST_TEST(std::abs(ref::rounding_error(method, Scalar::bits_113, h, n)) < 1e-30);
    }
    BOOST_TEST(ref::unrounded_place(method, 0.1, 0) == 1.0);
  }
  // One step by hand.
  BOOST_TEST(ref::unrounded_place(SwingMethod::verlet, 0.5, 1) == 0.875);
  BOOST_TEST(ref::unrounded_place(SwingMethod::runge_kutta, 0.5, 1) == 1.0 - 0.125 + 0.0625 / 24.0);
}

BOOST_AUTO_TEST_CASE(errors_of_the_methods_fall_at_their_orders) {
  // Leapfrog lags by t h^2/24, Runge-Kutta by t h^4/120.
  const double t = 10.0;
  for (const long n : {1000L, 2000L}) {
    const double h = t / static_cast<double>(n);
    BOOST_TEST(ref::method_error(SwingMethod::verlet, h, n) / (-std::sin(t) * t * h * h / 24.0) == 1.0,
               boost::test_tools::tolerance(1e-3));
    const double runge_kutta = std::sin(t) * t * std::pow(h, 4) / 120.0;
    BOOST_TEST(ref::method_error(SwingMethod::runge_kutta, h, n) / runge_kutta == 1.0,
               boost::test_tools::tolerance(3e-2));
  }
}

BOOST_AUTO_TEST_CASE(rounding_falls_with_the_numbers) {
  for (const SwingMethod method : {SwingMethod::verlet, SwingMethod::runge_kutta}) {
    const double in_double = std::abs(ref::rounding_error(method, Scalar::bits_53, 0.01, 10000));
    const double in_long_double = std::abs(ref::rounding_error(method, Scalar::bits_64, 0.01, 10000));
    BOOST_TEST(in_double < 1e4 * ref::unit_round_off(Scalar::bits_53));
    BOOST_TEST(in_long_double < 1e4 * ref::unit_round_off(Scalar::bits_64));
  }
}
