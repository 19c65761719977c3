#include "verification/reference/friction/resting_contact.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "verification/reference/mathematics/trajectory.hpp"

BOOST_AUTO_TEST_SUITE(resting_contact_tests)

namespace ref = talus::verification::reference;

namespace {

const ref::SlidingBlock block{10.0, 0.25, 0.4, 1e4, 4e4, 0.3, 9.81, 3.0};

}  // namespace

// The sliding motion is integrated with its vertical oscillation, which is damped and has decayed at the end.
BOOST_AUTO_TEST_CASE(the_block_stops_where_an_integration_stops) {
  const long double m = block.mass, k = 2.0 * block.normal_stiffness, g = block.gravity, mu = block.friction;
  const auto normal = [=](long double y, long double v) { return -k * y - 600.0L * v; };
  const auto rates = [=](const ref::Coordinates& y, ref::Coordinates& dydt) {
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = -mu * normal(y[1], y[3]) / m;
    dydt[3] = normal(y[1], y[3]) / m - g;
  };
  // Starts at half the static overlap: the normal force then remains repulsive.
  const double sunk = block.mass * block.gravity / (2.0 * block.normal_stiffness);
  ref::Trajectory truth(rates, {0.0L, -0.5L * sunk, 3.0L, 0.0L}, 0.0L, 0.001L);
  truth.advance_to(ref::stopping_time(block));
  BOOST_TEST(std::abs(static_cast<double>(truth.coordinates()[2])) < 1e-12);
  const double slid = 9.0 / (2.0 * 0.3 * 9.81) + 0.3 * 0.5 * sunk;
  BOOST_TEST(std::abs(static_cast<double>(truth.coordinates()[0]) - slid) < 1e-12 * slid);
}

// The displacement that the springs recover is that of their equilibrium while the block slides.
BOOST_AUTO_TEST_CASE(the_springs_recover_what_friction_had_stretched) {
  const double m = block.mass, g = block.gravity, mu = block.friction, k = block.normal_stiffness;
  const double tilt = mu * m * g * block.half_height / (2.0 * k * block.half_width * block.half_width);
  const double front = k * (m * g / (2.0 * k) + tilt * block.half_width);
  const double rear = k * (m * g / (2.0 * k) - tilt * block.half_width);
  BOOST_TEST(front + rear == m * g, boost::test_tools::tolerance(1e-14));
  // Moments about the centre: friction causes a forward rotation at the arm h.
  BOOST_TEST((front - rear) * block.half_width == mu * m * g * block.half_height, boost::test_tools::tolerance(1e-14));
  const double stretch = 0.5 * mu * (front + rear) / block.shear_stiffness;
  const double slid = block.speed * block.speed / (2.0 * mu * g) + mu * m * g / (2.0 * k);
  BOOST_TEST(ref::stopped_displacement(block) == slid - stretch - tilt * block.half_height,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(the_disc_rolls_as_an_integration_does) {
  const ref::RollingDisc disc{2.0, 0.013, 0.1, 1e5, 3e4, 9.81, 0.35};
  const long double arm = disc.radius - 0.5 * disc.mass * disc.gravity * std::cos(disc.angle) / disc.normal_stiffness;
  const long double drive = disc.gravity * std::sin(disc.angle);
  // x, angle, stretch
  const auto rates = [=](const ref::Coordinates& y, ref::Coordinates& dydt) {
    const long double slip = y[3] - arm * y[4], force = 3e4L * y[2] + 300.0L * slip;
    dydt[0] = y[3];
    dydt[1] = y[4];
    dydt[2] = slip;
    dydt[3] = drive - force / 2.0L;
    dydt[4] = force * arm / 0.013L;
  };
  ref::Trajectory truth(rates, {0.0L, 0.0L, 0.0L, 0.0L, 0.0L}, 0.0L, 0.001L);
  truth.advance_to(1.3L);
  BOOST_TEST(static_cast<double>(truth.coordinates()[0]) == ref::rolled_displacement(disc, 1.3),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(static_cast<double>(truth.coordinates()[4]) == ref::rolled_spin(disc, 1.3),
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
