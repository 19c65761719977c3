#include "verification/reference/motion/constant_force.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(constant_force_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr ref::ConstantForce flight{1.25, -3.5, 9.75};

}  // namespace

BOOST_AUTO_TEST_CASE(equation_start_and_energy) {
  BOOST_TEST(ref::position_at(flight, 0.0) == 1.25);
  BOOST_TEST(ref::speed_at(flight, 0.0) == -3.5);
  // Second differences of a parabola are exact: all numbers here have few binary digits.
  const double h = 0.125;
  for (const double t : {0.5, 1.0, 7.0}) {
    const double before = ref::position_at(flight, t - h), now = ref::position_at(flight, t),
                 after = ref::position_at(flight, t + h);
    BOOST_TEST((after - 2.0 * now + before) / (h * h) == 9.75);
    BOOST_TEST((after - before) / (2.0 * h) == ref::speed_at(flight, t));
    const double speed = ref::speed_at(flight, t);
    BOOST_TEST(0.5 * speed * speed - 9.75 * now == 0.5 * 3.5 * 3.5 - 9.75 * 1.25);
  }
}

BOOST_AUTO_TEST_CASE(euler_by_its_rule) {
  const double h = 0.0625;
  double x = flight.position, v = flight.speed;
  for (long n = 1; n <= 40; ++n) {
    v += h * flight.acceleration;
    x += h * v;
    const double t = h * static_cast<double>(n);
    BOOST_TEST(x - ref::position_at(flight, t) == ref::semi_implicit_euler_error(flight, h, n));
  }
}

BOOST_AUTO_TEST_SUITE_END()
