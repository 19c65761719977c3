#include "solver/calibrate/oblique_impact.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/laws/parameter.hpp"

BOOST_AUTO_TEST_SUITE(oblique_impact_tests)

using namespace talus;

namespace {

const auto near_enough = boost::test_tools::tolerance(1e-6);

RoundBody sphere(double mass, double radius) { return {mass, 0.4 * mass * radius * radius, radius}; }

/// A sphere of 2 kg that hits a plane; overlaps are 1e-7 of its radius.
ObliqueImpact impact_of(double friction, double stiffness_ratio, double angle) {
  constexpr double stiffness = 2e14;
  ObliqueImpact impact;
  impact.law = LinearSpringDashpot{stiffness, 0.0, EndRule::clamped};
  impact.friction = CoulombFriction{friction, stiffness_ratio * stiffness};
  impact.second = sphere(2.0, 1.0);
  impact.speed = 1.0, impact.angle = angle;
  return impact;
}

bool is_unreachable(const InputError& error) {
  return std::string{error.what()}.starts_with(
      "a tangential restitution of 0.1 is not reachable by friction; at this angle it must be ");
}

}  // namespace

// J = mu (1 + e) m v_n; the spin is r J/I.
BOOST_AUTO_TEST_CASE(a_contact_that_slides_throughout_loses_the_impulse_of_friction) {
  const ObliqueImpact impact = impact_of(0.1, 2.0 / 7.0, 1.2);
  const ObliqueRebound found = rebound(impact);
  const double lost = 2.0 * 0.1 * std::cos(1.2), after = std::sin(1.2) - lost;
  BOOST_TEST(found.restitution == 1.0, near_enough);
  BOOST_TEST(found.tangential_restitution == after / std::sin(1.2), near_enough);
  BOOST_TEST(found.rotational_restitution == 3.5 * lost / std::sin(1.2) - 1.0, near_enough);
  BOOST_TEST(found.spin == 2.5 * lost, near_enough);
  BOOST_TEST(found.angle == std::atan2(after, std::cos(1.2)), near_enough);
  BOOST_TEST(found.sticking < 0.005);
}

// Both springs oscillate in phase if n k_s = k: the slip rate is reversed.
BOOST_AUTO_TEST_CASE(a_contact_that_sticks_throughout_reverses_its_slip_rate) {
  const ObliqueRebound found = rebound(impact_of(2.0, 1.0 / 3.5, 0.1));
  BOOST_TEST(found.rotational_restitution == 1.0, near_enough);
  BOOST_TEST(found.tangential_restitution == 1.0 - 2.0 / 3.5, near_enough);
  BOOST_TEST(found.sticking > 0.99);
}

// Only mass and shape of the pair matter: two bodies of twice the mass are one of this mass and a plane.
BOOST_AUTO_TEST_CASE(two_bodies_move_as_one_of_their_effective_mass) {
  ObliqueImpact one = impact_of(0.3, 0.8, 0.6), two = one;
  two.first = sphere(4.0, 1.0), two.second = sphere(4.0, 1.0);
  BOOST_TEST(two.effective_mass() == one.effective_mass());
  BOOST_TEST(two.mobility() == one.mobility(), boost::test_tools::tolerance(1e-15));
  const ObliqueRebound of_one = rebound(one), of_two = rebound(two);
  BOOST_TEST(of_two.tangential_restitution == of_one.tangential_restitution, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(of_two.rotational_restitution == of_one.rotational_restitution, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(2.0 * of_two.spin == of_one.spin, boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(each_parameter_is_found_again) {
  ObliqueImpact springs = impact_of(0.2, 0.5, 0.5), damped = springs, spheres = springs, sticking = springs;
  std::get<CoulombFriction>(damped.friction).damping = 1e6;
  Hertz hertz;
  hertz.modulus = 1e14, hertz.radius = 1.0;
  spheres.law = sticking.law = hertz;
  spheres.friction = Mindlin{0.2, 2e13, 1.0, 0.0}, sticking.friction = Mindlin{5.0, 2e13, 1.0, 1e7};
  const std::vector<std::pair<ObliqueImpact, std::string>> all{{springs, "friction"},      {springs, "shear_stiffness"},
                                                               {damped, "shear_damping"},  {spheres, "friction"},
                                                               {spheres, "shear_modulus"}, {sticking, "shear_damping"}};
  for (const auto& [impact, name] : all) {
    const double wanted = rebound(impact).tangential_restitution;
    const TangentialCalibration found = calibrate_tangential(impact, name, wanted);
    BOOST_TEST(std::abs(found.rebound.tangential_restitution - wanted) < 1e-4);
    ObliqueImpact again = impact;
    set_parameter(again.friction, name, found.value);
    BOOST_TEST(rebound(again).tangential_restitution == found.rebound.tangential_restitution);
  }
}

// Without slip the slip rate returns to itself after a whole period of the tangential spring, n k_s = 4 k: e_t is 1,
// and less at the samples beside it. At n k_s = 16 k it is 1 again, near a sample: the smaller value must be found.
BOOST_AUTO_TEST_CASE(values_at_an_extreme_between_samples_are_found) {
  const ObliqueImpact impact = impact_of(20.0, 1.0, 0.1);
  const TangentialCalibration found = calibrate_tangential(impact, "shear_stiffness", 0.9998);
  BOOST_TEST(std::abs(found.rebound.tangential_restitution - 0.9998) < 1e-4);
  BOOST_TEST(std::abs(found.value / 2e14 - 4.0 / 3.5) < 0.05);
}

BOOST_AUTO_TEST_CASE(steps_are_accurate_for_both_restitutions) {
  const ObliqueImpact impact = impact_of(0.2, 0.5, 0.5);
  const ImpactError error = rebound_error(impact, make_integrator("velocity_verlet"));
  const double time = std::numbers::pi * std::sqrt(2.0 / 2e14);
  BOOST_TEST(error(time / 1000.0, 0.3) < 1e-4);
  BOOST_TEST(error(time / 10.0, 0.3) > error(time / 100.0, 0.3));
  BOOST_TEST(accurate_step(error, time, 1e-3).largest_error <= 1e-3);
}

BOOST_AUTO_TEST_CASE(impossible_oblique_impacts_are_refused) {
  BOOST_CHECK_EXCEPTION((void)calibrate_tangential(impact_of(0.2, 0.5, 0.5), "friction", 0.1), InputError,
                        is_unreachable);
  const auto says = [](const std::string& text) {
    return [text](const InputError& error) { return std::string{error.what()} == text; };
  };
  for (const double angle : {0.0, 0.5 * std::numbers::pi}) {
    BOOST_CHECK_EXCEPTION((void)rebound(impact_of(0.2, 0.5, angle)), InputError,
                          says("an oblique impact needs an angle in (0, 90) degrees and a speed > 0"));
  }
  ObliqueImpact soft = impact_of(0.2, 0.5, 0.5);
  soft.law = LinearSpringDashpot{1.0, 0.0, EndRule::clamped};
  BOOST_CHECK_EXCEPTION((void)rebound(soft), InputError,
                        says("the largest overlap would be 1.24 times the radius; it must be at most 0.5"));
  ObliqueImpact stuck = impact_of(0.2, 0.5, 0.5);
  stuck.law = LinearSpringDashpot{1.0, 10.0, EndRule::attractive};
  BOOST_CHECK_EXCEPTION(
      (void)rebound(stuck), InputError,
      says("so strong a damping never lets the contact end; choose a smaller one, or the clamped end rule"));
}

// With so strong a dashpot the stretch of Mindlin's friction, which does not slip at touch, changes at a rate without
// limit there.
BOOST_AUTO_TEST_CASE(an_impact_that_cannot_be_simulated_is_refused_with_the_reason) {
  ObliqueImpact impact = impact_of(50.0, 1.0, 0.35);
  Hertz hertz;
  hertz.modulus = 1e9, hertz.radius = 0.01, hertz.damping = 19.2;
  impact.law = hertz, impact.friction = Mindlin{50.0, 1e9, 0.01, 1e5};
  impact.second = sphere(1e-3, 0.01);
  BOOST_CHECK_EXCEPTION((void)rebound(impact), InputError, [](const InputError& error) {
    return std::string{error.what()}.starts_with(
        "the impact cannot be simulated; choose a smaller friction or dashpot: more than ");
  });
}

// Friction with a dashpot begins to slip: the restitutions on both sides of that value differ.
BOOST_AUTO_TEST_CASE(a_jump_past_the_wanted_restitution_is_an_error_with_both_sides) {
  ObliqueImpact impact = impact_of(0.2, 0.3, 20.0 * std::numbers::pi / 180.0);
  impact.law = LinearSpringDashpot{2e14, 2.9e6, EndRule::clamped};
  std::get<CoulombFriction>(impact.friction).damping = 6.3e5;
  std::string message;
  try {
    (void)calibrate_tangential(impact, "friction", 0.5);
  } catch (const InputError& error) {
    message = error.what();
  }
  BOOST_TEST_REQUIRE(message.starts_with("a tangential restitution of 0.5 is not reachable by friction: at "));
  const auto number_after = [&](const std::string& text) {
    return std::strtod(message.c_str() + message.find(text) + text.size(), nullptr);
  };
  const double value = number_after("friction: at "), above = number_after("from "), below = number_after(" to ");
  BOOST_TEST(above > 0.5 + 1e-4);
  BOOST_TEST(below < 0.5 - 1e-4);
  for (const auto& [factor, expected] : {std::pair{1.0 - 1e-5, above}, {1.0 + 1e-5, below}}) {
    set_parameter(impact.friction, "friction", factor * value);
    BOOST_TEST(std::abs(rebound(impact).tangential_restitution - expected) < 3e-3);
  }
}

BOOST_AUTO_TEST_SUITE_END()
