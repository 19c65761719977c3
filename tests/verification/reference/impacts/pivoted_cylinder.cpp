#include "verification/reference/impacts/pivoted_cylinder.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "verification/reference/impacts/restitution.hpp"

BOOST_AUTO_TEST_SUITE(pivoted_cylinder_tests)

namespace ref = talus::verification::reference;
using ref::EndRule;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
const ref::PivotedCylinder report;

}  // namespace

BOOST_AUTO_TEST_CASE(the_report_s_numbers_printed_and_corrected) {
  const ref::PivotedImpact impact = ref::rigid_impact(report);
  BOOST_TEST(std::abs(impact.column - 4.857) < 5e-4);
  BOOST_TEST(std::abs(impact.rock - 2.357) < 5e-4);
  BOOST_TEST(std::abs(ref::corrected_largest_angle(report, impact.angular) - 0.5042) < 5e-5);
  BOOST_TEST(std::abs(ref::printed_eq_28(report) - 0.9714) < 5e-5);
  BOOST_TEST(std::abs(ref::printed_largest_angle(report, impact.angular) - 0.3546) < 5e-5);
  BOOST_TEST(std::abs(ref::effective_column_mass(report) - 20.26) < 5e-3);
  BOOST_TEST(std::abs(ref::cylinder_inertia(14.9226, 8.0, 1.25) - 85.42) < 5e-3);  // 85.416; r = 1.2 gives 84.96
  BOOST_TEST(std::abs(ref::cylinder_inertia(14.9226, 8.0, 1.2) - 85.42) > 0.4);
}

BOOST_AUTO_TEST_CASE(impact_keeps_angular_momentum_and_restitution) {
  const ref::PivotedImpact impact = ref::rigid_impact(report);
  const double before = report.rock_mass * 4.0 * report.approach_speed;
  const double after = ref::inertia_about_pin(report) * impact.angular + report.rock_mass * 4.0 * impact.rock;
  BOOST_TEST(std::abs(after / before - 1.0) < 4 * eps);
  BOOST_TEST(std::abs(impact.column - impact.rock - 2.5) < 8 * eps);
}

BOOST_AUTO_TEST_CASE(swing_keeps_energy_as_corrected_not_as_printed) {
  const double w1 = ref::rigid_impact(report).angular;
  const ref::PendulumMotion swing = ref::swing(report, w1);
  const double largest = ref::corrected_largest_angle(report, w1);
  BOOST_TEST(std::abs(swing.amplitude() / largest - 1.0) < 8 * eps);
  BOOST_TEST(std::abs(swing.at(swing.period() / 4.0).angle / largest - 1.0) < 8 * eps);
  for (const double t : {0.1, 0.3, 0.9}) {
    const ref::PendulumState s = swing.at(t);
    BOOST_TEST(std::abs(s.rate * s.rate - ref::corrected_eq_30(report, w1, s.angle)) < 8 * eps);
    BOOST_TEST(std::abs(s.rate * s.rate - ref::printed_eq_30(report, w1, s.angle)) > 0.05);
    // The equation itself: I_p theta'' = -m g h sin theta.
    const double h = 1e-4;
    const double second = (swing.at(t + h).rate - swing.at(t - h).rate) / (2.0 * h);
    const double moment = -report.mass * report.gravity * 4.0 * std::sin(s.angle);
    BOOST_TEST(std::abs(ref::inertia_about_pin(report) * second - moment) < 1e-5);  // h^2/6 of w'''' times I_p
  }
  BOOST_TEST(std::isnan(ref::corrected_largest_angle(report, 10.0)));
}

BOOST_AUTO_TEST_CASE(eq_21_with_particle_masses_gives_another_restitution) {
  for (const double stiffness : {1e4, 1e8}) {
    const double wrong = ref::particle_damping(report, stiffness);
    BOOST_TEST(std::abs(ref::restitution_of(report, {stiffness, wrong, EndRule::attractive}) - 0.537) < 5e-4);
    const double right = ref::pivoted_damping(report, stiffness);
    BOOST_TEST(std::abs(ref::restitution_of(report, {stiffness, right, EndRule::attractive}) - 0.5) < 4 * eps);
  }
}

BOOST_AUTO_TEST_CASE(stiff_contact_tends_to_the_rigid_impact) {
  // Here gravity and the rotation of the arm act during the contact as well: all errors scale as t_c ~ k_n^(-1/2).
  const ref::PivotedImpact rigid = ref::rigid_impact(report);
  const double angle = ref::corrected_largest_angle(report, rigid.angular);
  const double quarter = ref::swing(report, rigid.angular).period() / 4.0;
  std::vector<std::array<double, 4>> errors;
  for (const double stiffness : {1e8, 1e10, 1e12}) {
    const ref::PivotedContact contact{stiffness, ref::pivoted_damping(report, stiffness), EndRule::attractive};
    const ref::PivotedSoftImpact soft = ref::soft_impact(report, contact);
    errors.push_back({std::abs(soft.column_speed - rigid.column), std::abs(soft.at_end.rock_vx - rigid.rock),
                      std::abs(soft.largest_angle - angle), std::abs(soft.turning_time - quarter)});
    BOOST_TEST(!soft.struck_again);
  }
  BOOST_TEST(errors[0][0] < 1e-3);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t quantity = 0; quantity < 4; ++quantity) {
      BOOST_TEST(std::abs(std::log10(errors[i][quantity] / errors[i + 1][quantity]) / 2.0 - 0.5) < 0.02);
    }
  }
}

BOOST_AUTO_TEST_CASE(energy_and_moment_through_the_contact) {
  // Without a dashpot the energy is conserved exactly, including that of the contact spring, and the event times do not
  // matter.
  const std::array<double, 4> times{0.002, 0.006, 0.01, 0.3};
  const ref::PivotedSoftImpact soft = ref::soft_impact(report, {1e6, 0.0, EndRule::clamped}, times);
  const double start = report.rock_mass * 25.0 / 2.0;
  for (const ref::PivotedState& s : soft.samples) {
    const double kinetic = report.rock_mass * (s.rock_vx * s.rock_vx + s.rock_vy * s.rock_vy) / 2.0 +
                           ref::inertia_about_pin(report) * s.rate * s.rate / 2.0;
    const double half = std::sin(s.angle / 2.0);
    const double height = report.mass * report.gravity * 8.0 * half * half;
    const double fall = report.rock_mass * report.gravity * s.rock_y;
    const double stored = s.contact_force * s.contact_force / 2e6;
    BOOST_TEST(std::abs((kinetic + height + fall + stored) / start - 1.0) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(depth_is_the_geometric_one) {
  const std::array<double, 3> times{0.003, 0.007, 0.010};
  const ref::PivotedContact contact{1e6, 500.0, EndRule::attractive};
  const ref::PivotedSoftImpact soft = ref::soft_impact(report, contact, times);
  for (const ref::PivotedState& s : soft.samples) {
    BOOST_TEST(s.contact_force != 0.0);
    // n . (p - p_G) with n = -(cos, sin), p_G = (h sin, h - h cos), and the velocity of the face's foot point.
    const double c = std::cos(s.angle);
    const double n = std::sin(s.angle);
    const double gx = 4.0 * n;
    const double gy = 4.0 - 4.0 * c;
    const double depth = report.rock_radius - (-(c * (s.rock_x - gx) + n * (s.rock_y - gy)) - report.half_width);
    const double along = -n * (s.rock_x - gx) + c * (s.rock_y - gy);
    const double foot_x = gx - report.half_width * c - n * along;
    const double foot_y = gy - report.half_width * n + c * along;
    const double face_vx = -s.rate * (foot_y - 4.0);  // rotation about the pin at (0, h)
    const double face_vy = s.rate * foot_x;
    const double closing = c * (s.rock_vx - face_vx) + n * (s.rock_vy - face_vy);
    BOOST_TEST(std::abs(1e6 * depth + 500.0 * closing - s.contact_force) < 1e6 * 20 * eps * 2.5);
  }
}

BOOST_AUTO_TEST_CASE(largest_force_and_rate_bound_the_samples) {
  const ref::PivotedContact contact{1e6, ref::pivoted_damping(report, 1e6), EndRule::attractive};
  const ref::PivotedSoftImpact once = ref::soft_impact(report, contact);
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i)
    times.push_back(once.at_end.t * i / 2000.0);
  double force = 0.0;
  double rate = 0.0;
  for (const ref::PivotedState& s : ref::soft_impact(report, contact, times).samples) {
    force = std::max(force, s.contact_force);
    rate = std::max(rate, s.rate);
  }
  BOOST_TEST(force <= once.peak_force * (1 + 4 * eps));
  BOOST_TEST(force > once.peak_force * (1 - 1e-5));  // (pi/2000)^2/8 = 3e-7 of a half sine
  BOOST_TEST(rate <= once.peak_rate * (1 + 4 * eps));
  BOOST_TEST(rate > once.peak_rate * (1 - 1e-5));
}

BOOST_AUTO_TEST_SUITE_END()
