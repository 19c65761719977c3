#include "verification/reference/motion/elastic_pendulum.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(elastic_pendulum_tests)

namespace ref = talus::verification::reference;

BOOST_AUTO_TEST_CASE(energy_and_start) {
  const ref::ElasticPendulum p{2.0, 1.5, 9.81, 400.0, 1.2};
  const std::array<double, 4> times{0.0, 0.4, 1.7, 5.0};
  std::vector<double> energies;
  for (const ref::ElasticPendulumState& s : ref::elastic_pendulum_states(p, times)) {
    const double stretch = std::hypot(s.x, s.y) - p.length;
    energies.push_back(p.mass * (s.vx * s.vx + s.vy * s.vy) / 2.0 + p.mass * p.gravity * s.y +
                       p.stiffness * stretch * stretch / 2.0);
  }
  for (const double energy : energies)
    BOOST_TEST(std::abs(energy - energies[0]) < 1e-13);
  const auto start = ref::elastic_pendulum_states(p, std::array{0.0})[0];
  BOOST_TEST(std::abs(std::atan2(start.x, -start.y) - 1.2) < 1e-15);
  BOOST_TEST(std::abs(std::hypot(start.x, start.y) - 1.5 - 2.0 * 9.81 * std::cos(1.2) / 400.0) < 1e-15);
  BOOST_TEST(start.vx == 0.0);
}

BOOST_AUTO_TEST_CASE(cartesian_equation) {
  const ref::ElasticPendulum p{2.0, 1.5, 9.81, 400.0, 1.2};
  const double h = 1e-4;
  const auto s = ref::elastic_pendulum_states(p, std::array{0.7 - h, 0.7, 0.7 + h});
  const double r = std::hypot(s[1].x, s[1].y);
  const double tension = p.stiffness * (r - p.length);
  // Central difference: h^2/6 times a third derivative of v, ~ (14/s)^3.
  BOOST_TEST(std::abs((s[2].vx - s[0].vx) / (2 * h) + tension * s[1].x / r / p.mass) < 1e-5);
  BOOST_TEST(std::abs((s[2].vy - s[0].vy) / (2 * h) + tension * s[1].y / r / p.mass + p.gravity) < 1e-5);
  BOOST_TEST(std::abs((s[2].x - s[0].x) / (2 * h) - s[1].vx) < 1e-6);
}

BOOST_AUTO_TEST_CASE(softening_of_small_swings_is_one_half) {
  BOOST_TEST(std::abs(ref::period_softening(1e-6) - 0.5) < 1e-11);
}

BOOST_AUTO_TEST_CASE(leading_order_holds_at_every_amplitude) {
  for (const double amplitude : {0.05, 0.5, 1.0, 1.4}) {
    std::vector<double> errors;
    for (const double softness : {4e-4, 2e-4, 1e-4}) {
      const ref::ElasticPendulum p{1.0, 1.0, 1.0, 1.0 / softness, amplitude};
      const double change = ref::elastic_pendulum_period(p) / ref::rigid_period(p) - 1.0;
      errors.push_back(change / softness - ref::period_softening(amplitude));
    }
    BOOST_TEST_MESSAGE(amplitude << " " << ref::period_softening(amplitude) << " " << errors[0] << " " << errors[2]);
    // The remainder is of first order in the softness: small, and halved with it (to a quarter over the three).
    BOOST_TEST(std::abs(errors[2]) < 30.0 * 1e-4);
    BOOST_TEST(std::abs(errors[2]) < 0.35 * std::abs(errors[0]));
  }
}

BOOST_AUTO_TEST_SUITE_END()
