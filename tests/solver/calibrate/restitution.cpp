#include "solver/laws/restitution.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "solver/base/error.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/stability/step_advice.hpp"

BOOST_AUTO_TEST_SUITE(restitution_tests)

using namespace talus;

BOOST_AUTO_TEST_CASE(damping_ratio_and_restitution_are_inverse) {
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    for (const double e : {0.01, 0.05, 0.1353, 0.3, 0.5, 0.9, 0.999, 1.0}) {
      BOOST_TEST(restitution(damping_ratio(e, rule), rule) == e, boost::test_tools::tolerance(1e-13));
    }
  }
}

BOOST_AUTO_TEST_CASE(clamped_restitution_passes_smoothly_through_critical_damping) {
  BOOST_TEST(restitution(1.0, EndRule::clamped) == std::exp(-2.0), boost::test_tools::tolerance(1e-15));
  // d(ln e)/d(xi) at 1 is -4/3: the slope on both sides of the series' range.
  for (const double xi : {1.0 - 2e-4, 1.0 - 5e-5, 1.0 + 5e-5, 1.0 + 2e-4}) {
    const double line = -2.0 - 4.0 / 3.0 * (xi - 1.0);
    BOOST_TEST(std::abs(std::log(restitution(xi, EndRule::clamped)) - line) < 2e-8);  // second order, 0.3 (xi - 1)^2
  }
  BOOST_TEST(restitution(1.0, EndRule::attractive) == 0.0);
}

BOOST_AUTO_TEST_CASE(effective_mass_of_particles_levers_and_pins) {
  BOOST_TEST(effective_mass({2.0, {}, 0.0, false}, {3.0, {}, 0.0, false}) == 1.2, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(effective_mass({2.0, 0.5, 1.0, false}, {1e300, {}, 0.0, false}) == 0.4,
             boost::test_tools::tolerance(1e-15));
  BOOST_TEST(effective_mass({1e300, {}, 0.0, false}, {0.0, 8.0, 2.0, true}) == 2.0,
             boost::test_tools::tolerance(1e-15));
  BOOST_CHECK_THROW(static_cast<void>(effective_mass({0.0, {}, 0.0, false}, {1.0, {}, 0.0, false})), InputError);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_reached_is_refused) {
  for (const double e : {0.0, -0.1, 1.01, std::numeric_limits<double>::quiet_NaN()}) {
    BOOST_CHECK_THROW(static_cast<void>(damping_ratio(e, EndRule::clamped)), InputError);
    BOOST_CHECK_THROW(static_cast<void>(damping_ratio(e, EndRule::attractive)), InputError);
  }
}

BOOST_AUTO_TEST_CASE(advised_step_keeps_the_stated_error) {
  const LinearSpringDashpot law{1e4, damping(damping_ratio(0.5, EndRule::clamped), 1e4, 2.0), EndRule::clamped};
  const ImpactStep advised = advise_impact_step(law, 2.0, 1.0, 1e-3, VelocityVerlet{});
  for (const double phase : {0.0, 0.11, 0.37, 0.73, 1.0}) {
    const double e = simulate_impact(law, 2.0, 3.0, advised.step, phase, VelocityVerlet{}).restitution;
    BOOST_TEST(std::abs(e - 0.5) < 1.1e-3);  // phases that were not used to choose the step
  }
}

BOOST_AUTO_TEST_CASE(a_step_is_advised_for_heavy_damping_too) {
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    for (const double e : {0.04, 0.01, 0.001}) {
      const LinearSpringDashpot law{1e4, damping(damping_ratio(e, rule), 1e4, 1.0), rule};
      const ImpactStep advised = advise_impact_step(law, 1.0, 1.0, 1e-3, VelocityVerlet{});
      BOOST_TEST(std::abs(advised.restitution - e) < 1e-3);
    }
  }
}

BOOST_AUTO_TEST_CASE(scene_is_calibrated_by_simulation) {
  Scene scene =
      scenes::pivoted_cylinder({.gravity = 0.0, .contact = LinearSpringDashpot{1e7, 0.0, EndRule::attractive}});
  scene.integrator = make_integrator("velocity_verlet");
  scene.plan = {1e-5, 0.2, 0.1, false};
  const Calibration found = calibrate(scene, ContactId{0}, 0.5, 1e-6);
  BOOST_TEST(std::abs(found.impact.restitution - 0.5) < 1e-6);
  // Effective mass of the pinned column at the line of impact, I_p/h^2: 85.42/16 + 14.92 slug.
  const double mass = effective_mass({37.23, {}, 0.0, false}, {14.92 + 85.42 / 16.0, {}, 0.0, false});
  const double formula = damping(damping_ratio(0.5, EndRule::attractive), 1e7, mass);
  BOOST_TEST(std::abs(found.dissipation / formula - 1.0) <
             5e-3);  // the column turns a little during the contact: 1/sqrt(k_n)
  BOOST_CHECK_THROW(static_cast<void>(calibrate(scene, ContactId{0}, 1.5)), InputError);
}

BOOST_AUTO_TEST_CASE(highest_frequency_of_the_pivoted_impact) {
  const Scene scene = scenes::pivoted_cylinder({.contact = LinearSpringDashpot{1e6, 100.0, EndRule::clamped}});
  const Dynamics dynamics{scene.model};
  const StepAdvice advice = advise_step(dynamics, scene.initial);
  const double mass = effective_mass({37.23, {}, 0.0, false}, {14.92 + 85.42 / 16.0, {}, 0.0, false});
  BOOST_TEST(advice.highest_frequency() == std::sqrt(1e6 / mass), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(advice.modes.back().damping_ratio == 100.0 / (2.0 * std::sqrt(1e6 * mass)),
             boost::test_tools::tolerance(1e-12));
  BOOST_REQUIRE(advice.springs.size() == 1);
  BOOST_TEST(advice.springs[0].frequency == advice.highest_frequency(), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(laws_without_a_dashpot_report_their_stiffest_branch) {
  const Scene scene = scenes::bouncing_disc({.gap = 1.0, .contact = LatchingSpring{100.0, 400.0, 0.0}});
  const Dynamics dynamics{scene.model};
  const StepAdvice advice = advise_step(dynamics, scene.initial);
  BOOST_TEST(advice.highest_frequency() == 20.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(advice.shortest_contact == std::numbers::pi / 20.0, boost::test_tools::tolerance(1e-12));
  BOOST_CHECK_EXCEPTION((void)with_dissipation(scene, ContactId{0}, 1.0), InputError, [](const InputError& error) {
    return std::string{error.what()} == "contact 'impact': the law 'latching_spring' has no damping";
  });
}

BOOST_AUTO_TEST_CASE(an_impact_of_any_law_is_followed_to_its_end) {
  Scene scene = scenes::bouncing_disc({.radius = 8.0, .gap = 0.01, .contact = LatchingSpring{1.0, 4.0, 0.0}});
  scene.integrator = VelocityVerlet{};
  scene.plan = {1e-3, 4.0, 1.0, false};
  const Impact impact = simulate_impact(scene, ContactId{0});
  BOOST_TEST(impact.restitution == 0.5, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(impact.largest_force == 1.0, boost::test_tools::tolerance(1e-5));
  // A quarter period of each branch, and up to two steps.
  BOOST_TEST(std::abs(impact.contact_time - 0.75 * std::numbers::pi) < 2.1e-3);
}

BOOST_AUTO_TEST_CASE(a_slow_mode_with_a_strong_dashpot_may_rule_the_step) {
  StepAdvice advice;
  advice.modes = {{100.0, 50.0}, {1000.0, 0.0}};
  const auto limit = step_limit(advice.modes, "velocity_verlet");
  BOOST_REQUIRE(limit.has_value());
  BOOST_TEST(limit->mode.frequency == 100.0);
  BOOST_TEST(limit->step == 2.0 * (std::sqrt(2501.0) - 50.0) / 100.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
