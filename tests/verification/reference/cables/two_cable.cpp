#include "verification/reference/cables/two_cable.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"

BOOST_AUTO_TEST_SUITE(two_cable_tests)

namespace ref = talus::verification::reference;
using ref::Real50;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

ref::TwoCableMotion report_motion() {
  const ref::TwoCable problem;
  return {problem, ref::rigid_impact(problem).particle};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_report_s_numbers) {
  const ref::TwoCableImpact impact = ref::rigid_impact({});
  BOOST_TEST(impact.particle == 2.0);
  BOOST_TEST(impact.striker == 1.0);
  const ref::TwoCableMotion motion = report_motion();
  // s_max = 2 sqrt(1/8) = 1/sqrt 2; x_max = sqrt(s_max (s_max + 20)).
  const double s = std::numbers::sqrt2 / 2.0;
  BOOST_TEST(std::abs(motion.largest_distance() / std::sqrt(s * (s + 20.0)) - 1.0) < 2 * eps);
  BOOST_TEST(std::abs(motion.largest_distance() - 3.82650) < 5e-6);
  BOOST_TEST(std::abs(motion.largest_angle() - 0.36546) < 5e-6);
}

BOOST_AUTO_TEST_CASE(momentum_and_restitution) {
  const ref::TwoCable problem{3.0, 7.0, 0.4, 5.0, 0.3, 1.7};
  const ref::TwoCableImpact impact = ref::rigid_impact(problem);
  BOOST_TEST(std::abs(0.4 * impact.particle + 5.0 * impact.striker - 5.0 * 1.7) < 10 * eps);
  BOOST_TEST(std::abs(impact.particle - impact.striker - 0.3 * 1.7) < 10 * eps);
}

BOOST_AUTO_TEST_CASE(speed_is_energy_and_both_forms_agree) {
  const ref::TwoCable problem;
  const ref::TwoCableMotion motion = report_motion();
  for (int i = 0; i <= 20; ++i) {
    const double x = motion.largest_distance() * i / 20.0 * (1.0 - 1e-12);
    const double v = motion.speed_at_distance(x);
    const double stretch = std::hypot(problem.length, x) - problem.length;
    const double energy = problem.mass * v * v / 2.0 + problem.stiffness * stretch * stretch;
    BOOST_TEST(std::abs(energy / 2.0 - 1.0) < 1e-13);  // the elongation by difference: eps l/s_max, squared
    BOOST_TEST(std::abs(motion.speed_at_angle(std::atan(x / problem.length)) - v) < 1e-9);  // v ~ sqrt near the end
    BOOST_TEST(std::abs(ref::cable_tension(problem, x) - problem.stiffness * stretch) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(time_against_the_singular_integral) {
  // The plain integral of dx/v by tanh-sinh, which handles the end-point singularity. Near x_max the rule provides the
  // distance to the end, so that v keeps its digits.
  const ref::TwoCableMotion motion = report_motion();
  const Real50 s_max = 1 / sqrt(Real50(2));
  const Real50 x_max = sqrt(s_max * (s_max + 20));
  const auto slowness = [&](const Real50& x, const Real50& to_end) {
    const Real50 s = x * x / (sqrt(100 + x * x) + 10);
    const Real50 gap = x > x_max / 2 ? Real50(abs(to_end)) : Real50(x_max - x);
    return Real50(1 / sqrt(8 * gap * (x_max + x) / (s_max + s + 20) * (s_max + s)));
  };
  boost::math::quadrature::tanh_sinh<Real50> rule(12);
  const Real50 truth = rule.integrate(slowness, Real50(0), x_max, Real50("1e-40"));
  BOOST_TEST((abs(Real50(motion.time_to_turning_40_digits()) / truth - 1) < Real50("1e-37")));
  BOOST_TEST(std::abs(motion.time_to_turning() / ref::nearest(truth) - 1.0) <= eps);
}

BOOST_AUTO_TEST_CASE(small_impact_is_a_cubic_spring) {
  // m x'' = -(k/l^2) x^3 for x << l: quarter period K(1/sqrt 2)/(A sqrt(k/(m l^2))), K = Gamma(1/4)^2/(4 sqrt pi).
  const ref::TwoCable problem;
  const ref::TwoCableMotion motion(problem, 1e-8);
  const double a = motion.largest_distance();
  const double gamma = std::tgamma(0.25);
  const double quarter = gamma * gamma / (4.0 * std::sqrt(std::numbers::pi)) * problem.length / (a * 2.0);
  BOOST_TEST(std::abs(motion.time_to_turning() / quarter - 1.0) < 2.0 * a * a / 100.0);  // corrections (A/l)^2
}

BOOST_AUTO_TEST_CASE(the_motion_satisfies_its_equation) {
  const ref::TwoCable problem;
  const ref::TwoCableMotion motion = report_motion();
  BOOST_TEST(motion.at(0.0).position == 0.0);
  BOOST_TEST(std::abs(motion.at(0.0).velocity - 2.0) < 2 * eps);
  const double quarter = motion.time_to_turning();
  const double h = 2e-3;
  for (int i = 0; i < 40; ++i) {
    const double t = 0.05 + 4.1 * quarter * i / 40.0;
    const auto now = motion.at(t);
    // Fourth-order differences: h^4/30 times a fifth derivative below 10 is 5e-12, round-off eps/h = 1e-13.
    const auto slope = [&](auto member) {
      return (8.0 * (motion.at(t + h).*member - motion.at(t - h).*member) -
              (motion.at(t + 2 * h).*member - motion.at(t - 2 * h).*member)) /
             (12.0 * h);
    };
    const double length = std::hypot(problem.length, now.position);
    const double pull = 2.0 * ref::cable_tension(problem, now.position) * now.position / length;
    BOOST_TEST(std::abs(slope(&ref::TwoCableMotion::State::position) - now.velocity) < 1e-10);
    BOOST_TEST(std::abs(slope(&ref::TwoCableMotion::State::velocity) + pull / problem.mass) < 1e-10);
    BOOST_TEST(std::abs(motion.speed_at_distance(now.position) - std::abs(now.velocity)) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(time_and_position_are_inverse) {
  const ref::TwoCableMotion motion = report_motion();
  for (const double x : {1e-6, 0.3, 1.0, 2.7, 3.8}) {
    BOOST_TEST(std::abs(motion.at(motion.time_to_distance(x)).position - x) < 2 * eps * 4.0);
  }
  BOOST_TEST(motion.time_to_distance(0.0) == 0.0);
  BOOST_TEST(motion.time_to_distance(motion.largest_distance()) == motion.time_to_turning(),
             boost::test_tools::tolerance(2e-8));  // t ~ sqrt of the half ulp by which x_max is rounded
  BOOST_CHECK_THROW((void)motion.time_to_distance(3.9), std::invalid_argument);
  BOOST_CHECK_THROW((void)motion.at(-1.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
