#include "verification/reference/integration/stepped_swing.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(stepped_swing_tests)

namespace ref = talus::verification::reference;
using ref::SwingMethod;

namespace {

constexpr std::array methods{SwingMethod::euler_cromer, SwingMethod::central_difference,
                             SwingMethod::lagged_central_difference, SwingMethod::velocity_verlet,
                             SwingMethod::runge_kutta};

}  // namespace

BOOST_AUTO_TEST_CASE(one_step_by_hand) {
  // c = 1, h = 1/2, from rest at 1; v after a kick is -1/2, lagged or not, because the dashpot has no velocity yet.
  const auto position = [](SwingMethod method, long n) { return ref::unrounded_position({method, 1.0, 0.5, n}); };
  for (const SwingMethod method : methods)
    BOOST_TEST(position(method, 0) == 1.0);
  BOOST_TEST(position(SwingMethod::euler_cromer, 1) == 0.75);
  BOOST_TEST(position(SwingMethod::central_difference, 1) == 0.875);
  BOOST_TEST(position(SwingMethod::lagged_central_difference, 1) == 0.875);
  BOOST_TEST(position(SwingMethod::velocity_verlet, 1) == 0.875);
  // 1 - h^2/2 + h^3/6 (with c = 1 the third derivative of -x - x' is 1, the fourth is 0).
  BOOST_TEST(position(SwingMethod::runge_kutta, 1) == 1.0 - 0.125 + 0.125 / 6.0);
  // Second step: x = 3/4, v = -1/2: the kick is -3/8 + 1/4, or the dashpot uses the previous zero velocity.
  BOOST_TEST(position(SwingMethod::euler_cromer, 2) == 0.75 + 0.5 * (-0.5 - 0.125));
  BOOST_TEST(position(SwingMethod::central_difference, 2) == 0.75 + 0.25 * (-0.5 - 0.125));
  BOOST_TEST(position(SwingMethod::lagged_central_difference, 2) == 0.75 + 0.25 * (-0.5 - 0.375));
  // Verlet: v' = -1/4, x = 7/8, a = -7/8 + 1/4 = -5/8, v = -1/4 - 5/32; v' = v - 5/32; x += v'/2.
  BOOST_TEST(position(SwingMethod::velocity_verlet, 2) == 0.875 + 0.5 * (-0.25 - 0.15625 - 0.15625));
}

BOOST_AUTO_TEST_CASE(undamped_maps_have_closed_forms) {
  // Leapfrog advances the phase by theta per step, sin(theta/2) = h/2; positions of Euler-Cromer are half a step ahead.
  // The closed form itself is rounded by a few n eps.
  for (const double h : {0.5, 0.1, 0.013}) {
    const double theta = 2.0 * std::asin(0.5 * h);
    for (const long n : {1L, 2L, 17L, 500L}) {
      const double t = static_cast<double>(n) * theta;
      const auto position = [&](SwingMethod method) { return ref::unrounded_position({method, 0.0, h, n}); };
      BOOST_TEST(std::abs(position(SwingMethod::velocity_verlet) - std::cos(t)) < 1e-14 * (1.0 + t));
      BOOST_TEST(position(SwingMethod::central_difference) == position(SwingMethod::velocity_verlet));
      BOOST_TEST(position(SwingMethod::lagged_central_difference) == position(SwingMethod::velocity_verlet));
      BOOST_TEST(std::abs(position(SwingMethod::euler_cromer) - std::cos(t + 0.5 * theta) / std::cos(0.5 * theta)) <
                 1e-14 * (1.0 + t));
    }
  }
}

BOOST_AUTO_TEST_CASE(errors_fall_at_the_orders_with_the_constants_of_the_methods) {
  // Leapfrog is fast by h^2/24, Runge-Kutta slow by h^4/120; Euler-Cromer is half a step ahead.
  const double t = 10.0;
  for (const long n : {1000L, 2000L}) {
    const double h = t / static_cast<double>(n);
    const auto ratio = [&](SwingMethod method, double predicted) {
      const ref::SteppedSwing swing{method, 0.0, h, n};
      return ref::whole_error(swing, {ref::unrounded_position(swing), 0.0, 0.0}) / predicted;
    };
    BOOST_TEST(ratio(SwingMethod::velocity_verlet, -std::sin(t) * t * h * h / 24.0) == 1.0,
               boost::test_tools::tolerance(1e-3));
    BOOST_TEST(ratio(SwingMethod::runge_kutta, std::sin(t) * t * std::pow(h, 4) / 120.0) == 1.0,
               boost::test_tools::tolerance(3e-2));
    BOOST_TEST(ratio(SwingMethod::euler_cromer, -std::sin(t) * h / 2.0) == 1.0, boost::test_tools::tolerance(1e-2));
  }
  BOOST_CHECK_THROW(static_cast<void>(ref::whole_error({SwingMethod::runge_kutta, 0.1, 0.1, 1}, {})),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(damped_maps_tend_to_the_damped_oscillator) {
  // x = e^(-c t/2) (cos w t + c/(2 w) sin w t), w^2 = 1 - c^2/4; at c = 0.1, t = 10 the least accurate method, first
  // order with a lag of 3/2 h, is off by less than c h t.
  const double c = 0.1, t = 10.0, w = std::sqrt(1.0 - 0.25 * c * c), h = 1e-4;
  const double exact = std::exp(-0.5 * c * t) * (std::cos(w * t) + c / (2.0 * w) * std::sin(w * t));
  for (const SwingMethod method : methods)
    BOOST_TEST(std::abs(ref::unrounded_position({method, c, h, 100000}) - exact) < c * h * t);
  BOOST_TEST(std::abs(ref::unrounded_position({SwingMethod::runge_kutta, c, h, 100000}) - exact) < 1e-14);
}

BOOST_AUTO_TEST_CASE(distances_are_resolved_below_a_double_s_last_place) {
  // x = 7/8 after a step; a position 2^-100 away, given in parts.
  const ref::SteppedSwing swing{SwingMethod::velocity_verlet, 0.0, 0.5, 1};
  const std::vector<double> errors = ref::rounding_errors(swing, {{0.875, 0.0, 0.0}, {0.875, 0x1p-100, -0x1p-101}});
  BOOST_TEST(errors[0] == 0.0);
  BOOST_TEST(errors[1] == 0x1p-101);
}

BOOST_AUTO_TEST_SUITE_END()
