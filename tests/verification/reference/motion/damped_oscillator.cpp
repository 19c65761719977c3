#include "verification/reference/motion/damped_oscillator.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(damped_oscillator_tests)

namespace ref = talus::verification::reference;

BOOST_AUTO_TEST_CASE(equation_start_and_energy) {
  const double w0 = 7.0;
  for (const double xi : {0.0, 0.05, 0.6, 0.99}) {
    const ref::DampedOscillator oscillator{w0, xi, 0.3, -1.25};
    const ref::OscillatorState start = ref::state_at(oscillator, 0.0);
    BOOST_TEST(start.displacement == 0.3);
    BOOST_TEST(start.velocity == -1.25);
    BOOST_TEST(std::abs(start.squared_velocity) < 1e-15);
    for (const double t : {0.2, 1.0, 2.5}) {
      // Sixth-order differences: the truncation is (w0 h)^6/140, rounding 1e-16/h.
      const double h = 2e-3;
      const auto slope = [&](auto member) {
        const auto value = [&](int n) { return ref::state_at(oscillator, t + n * h).*member; };
        return (45.0 * (value(1) - value(-1)) - 9.0 * (value(2) - value(-2)) + value(3) - value(-3)) / (60.0 * h);
      };
      const ref::OscillatorState now = ref::state_at(oscillator, t);
      BOOST_TEST(std::abs(slope(&ref::OscillatorState::displacement) - now.velocity) < 1e-11);
      const double acceleration = -w0 * w0 * now.displacement - 2.0 * xi * w0 * now.velocity;
      BOOST_TEST(std::abs(slope(&ref::OscillatorState::velocity) - acceleration) < 1e-10);
      BOOST_TEST(std::abs(slope(&ref::OscillatorState::squared_velocity) - now.velocity * now.velocity) < 1e-11);
      const auto energy = [&](const ref::OscillatorState& state) {
        return 0.5 * state.velocity * state.velocity + 0.5 * w0 * w0 * state.displacement * state.displacement;
      };
      BOOST_TEST(std::abs(energy(start) - energy(now) - 2.0 * xi * w0 * now.squared_velocity) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(out_of_range) {
  BOOST_CHECK_THROW((void)ref::state_at({0.0, 0.1, 1.0, 0.0}, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::state_at({1.0, 1.0, 1.0, 0.0}, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::state_at({1.0, 0.1, 1.0, 0.0}, -1.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
