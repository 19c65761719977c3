#include "verification/reference/cables/two_cable_contact.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "verification/reference/impacts/restitution.hpp"

BOOST_AUTO_TEST_SUITE(two_cable_contact_tests)

namespace ref = talus::verification::reference;
using ref::EndRule;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

ref::SoftContact report_contact(double stiffness, EndRule end) {
  return {stiffness, ref::eq_21_damping(0.5, stiffness, ref::effective_mass(1.0, 0.5)), end};
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_cables_it_is_the_closed_form) {
  const ref::TwoCable free{0.0, 10.0, 1.0, 2.0, 0.5, 2.0};
  for (const EndRule end : {EndRule::attractive, EndRule::clamped}) {
    for (const double damping : {0.0, 3.0, 9.0}) {
      const ref::ImpactEvents truth = ref::impact_events({1e3, damping, 2.0 / 3.0, 2.0}, end);
      const ref::TwoCableContact soft = ref::soft_impact(free, {1e3, damping, end});
      const double e = (soft.at_end.particle_velocity - soft.at_end.striker_velocity) / 2.0;
      BOOST_TEST(std::abs(e - truth.restitution) < 4 * eps);
      BOOST_TEST(std::abs(soft.at_end.t / truth.contact_time - 1.0) < 4 * eps);
      BOOST_TEST(std::abs(soft.largest_depth / truth.largest_depth - 1.0) < 4 * eps);
      BOOST_TEST(std::abs(soft.peak_force / truth.largest_force - 1.0) < 4 * eps);
      BOOST_TEST(std::abs(soft.depth_at_end - truth.depth_at_end) < 4 * eps * truth.largest_depth);
      BOOST_TEST(std::abs(soft.at_end.particle_velocity + 2.0 * soft.at_end.striker_velocity - 4.0) < 4 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(energy_without_damping) {
  const ref::TwoCable problem;
  const std::array<double, 6> times{0.0, 0.001, 0.004, 0.5, 1.0, 2.0};
  const ref::TwoCableContact soft = ref::soft_impact(problem, {1e4, 0.0, EndRule::attractive}, times);
  BOOST_TEST(soft.samples.size() == times.size());
  for (const ref::TwoCableState& s : soft.samples) {
    const double stretch = std::hypot(10.0, s.particle_position) - 10.0;
    const double depth = s.contact_force / 1e4;
    const double energy = s.particle_velocity * s.particle_velocity / 2.0 + s.striker_velocity * s.striker_velocity +
                          4.0 * stretch * stretch + 1e4 * depth * depth / 2.0;
    BOOST_TEST(std::abs(energy / 4.0 - 1.0) < 1e-14);
  }
  // The turning point from the energy at the end of contact.
  const ref::TwoCableState& end = soft.at_end;
  const double s0 = std::hypot(10.0, end.particle_position) - 10.0;
  const double s1 = std::sqrt(s0 * s0 + end.particle_velocity * end.particle_velocity / 8.0);
  BOOST_TEST(std::abs(soft.turning_distance / std::sqrt(s1 * (s1 + 20.0)) - 1.0) < 8 * eps);
  BOOST_TEST(std::abs(soft.turning_angle - std::atan(soft.turning_distance / 10.0)) < 2 * eps);
}

BOOST_AUTO_TEST_CASE(both_end_rules_tend_to_their_rigid_limits) {
  const ref::TwoCable problem;
  const ref::TwoCableMotion rigid(problem, 2.0);
  const ref::TwoCableContact attractive = ref::soft_impact(problem, report_contact(1e10, EndRule::attractive));
  BOOST_TEST(std::abs(attractive.turning_distance - 3.82650) < 5e-5);
  BOOST_TEST(std::abs(attractive.turning_angle - 0.36546) < 5e-6);
  BOOST_TEST(!attractive.struck_again);
  BOOST_TEST(std::abs(attractive.turning_time - rigid.time_to_turning()) < 1e-4);
  // With the clamped rule e is 0.5502 instead of 0.5: v1 = 2 (1 + e) 2/3 = 2.067, x = 3.892.
  const ref::TwoCableContact clamped = ref::soft_impact(problem, report_contact(1e10, EndRule::clamped));
  BOOST_TEST(std::abs(clamped.turning_distance - 3.892) < 5e-4);
  // The peak speed of the attractive contact occurs where its force becomes attractive: the clamped exit speed.
  const double e = ref::restitution(ref::damping_ratio(0.5, EndRule::attractive), EndRule::clamped);
  BOOST_TEST(std::abs(attractive.peak_speed - 4.0 / 3.0 * (1.0 + e)) < 1e-5);
  BOOST_TEST(std::abs(clamped.at_end.particle_velocity - 4.0 / 3.0 * (1.0 + e)) < 1e-5);
}

BOOST_AUTO_TEST_CASE(approach_to_the_rigid_limit) {
  // t_c ~ k_n^(-1/2). The force of the cables scales as x^3 ~ (v t)^3, so its impulse during the contact scales as
  // t_c^4: exit speed and distance converge as k_n^(-2). The turning time is late by the delay within the contact: t_c.
  const ref::TwoCable problem;
  const ref::TwoCableMotion rigid(problem, 2.0);
  std::vector<double> speed;
  std::vector<double> distance;
  std::vector<double> late;
  for (const double stiffness : {400.0, 1600.0, 6400.0}) {
    const ref::TwoCableContact soft = ref::soft_impact(problem, report_contact(stiffness, EndRule::attractive));
    speed.push_back(std::abs(soft.at_end.particle_velocity - 2.0));
    distance.push_back(std::abs(soft.turning_distance - rigid.largest_distance()));
    late.push_back(soft.turning_time - rigid.time_to_turning());
  }
  for (std::size_t i = 0; i < 2; ++i) {
    BOOST_TEST(std::abs(std::log2(speed[i] / speed[i + 1]) / 2.0 - 2.0) < 0.02);
    BOOST_TEST(std::abs(std::log2(distance[i] / distance[i + 1]) / 2.0 - 2.0) < 0.02);
    BOOST_TEST(std::abs(std::log2(late[i] / late[i + 1]) / 2.0 - 0.5) < 0.01);
  }
}

BOOST_AUTO_TEST_CASE(samples_join_at_the_end_of_contact) {
  const ref::TwoCable problem;
  const ref::SoftContact contact = report_contact(1e5, EndRule::clamped);
  const ref::TwoCableContact once = ref::soft_impact(problem, contact);
  const std::vector<double> times{once.at_end.t * (1 - 1e-9), once.at_end.t * (1 + 1e-9), once.turning_time};
  const ref::TwoCableContact soft = ref::soft_impact(problem, contact, times);
  BOOST_TEST(std::abs(soft.samples[0].particle_velocity - soft.samples[1].particle_velocity) < 1e-8);
  BOOST_TEST(soft.samples[0].contact_force > 0.0);
  BOOST_TEST(soft.samples[1].contact_force == 0.0);
  BOOST_TEST(std::abs(soft.samples[2].particle_velocity) < 4 * eps);
  BOOST_TEST(std::abs(soft.samples[2].particle_position - once.turning_distance) < 4 * eps);
  BOOST_CHECK_THROW((void)ref::soft_impact(problem, {0.0, 0.0, EndRule::clamped}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
