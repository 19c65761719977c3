/// The run monitor (solver/stability/run_monitor.hpp), on both sides of each of its limits.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/stability/run_monitor.hpp"
#include "solver/stability/step_advice.hpp"

BOOST_AUTO_TEST_SUITE(run_monitor_tests)

using namespace talus;

namespace {

/// A monitored run to its end or to a violation.
struct WatchedRun {
  std::string violation;
  std::vector<std::string> warnings;
  double time{};
  double ratio{};  ///< largest overlap, relative to half the smallest width of the bodies
};

WatchedRun run(Scene scene, double step, double end, const char* method = "velocity_verlet",
               const MonitorRules& rules = {}) {
  scene.integrator = make_integrator(method, needs_tolerance(method) ? 1e-9 : 0.0);
  scene.plan = {step, end, end, true, rules};
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, true};
  State state = scene.initial;
  system.begin(state);
  RunMonitor watch{scene, dynamics, state};
  watch.check(Snapshot{dynamics, state}, 0);
  if (watch.violation().empty()) {
    long n = 0;
    const Outcome outcome = simulate(system, scene.integrator, state, scene.plan, {}, [&](const Snapshot& seen) {
      watch.check(seen, ++n);
      return !watch.violation().empty();
    });
    BOOST_TEST(static_cast<bool>(outcome));
  }
  return {watch.violation(), watch.warnings(), state.t, watch.extreme(Watched::overlap).value};
}

bool says(const std::string& text, const char* expected) { return text.find(expected) != std::string::npos; }

/// A disc of mass and radius 1 compressed between two planes, w = 100 of both springs together.
Scene squeezed() {
  ModelBuilder builder;
  const BodyId disc = builder.add(
      Body{.name = "disc", .mobility = Mobility::sliding_y, .mass = 1.0, .shape = Circle{1.0}, .p_WB = {0.0, 0.0}});
  for (const double side : {1.0, -1.0}) {
    const BodyId plane = builder.add(Body{.name = side > 0.0 ? "below" : "above",
                                          .mobility = Mobility::fixed,
                                          .shape = HalfPlane{},
                                          .p_WB = {0.0, -0.98 * side},
                                          .angle = side > 0.0 ? 0.0 : std::acos(-1.0)});
    builder.add(Contact{.name = side > 0.0 ? "lower" : "upper",
                        .a = plane,
                        .b = disc,
                        .law = LinearSpringDashpot{5000.0, 0.0, EndRule::clamped}});
  }
  Scene scene{.title = "squeezed", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  return scene;
}

/// A disc of radius 0.1 that moves towards a fixed one of the same size, 50 away.
Scene shot(double speed) {
  ModelBuilder builder;
  const BodyId post =
      builder.add(Body{.name = "post", .mobility = Mobility::fixed, .shape = Circle{0.1}, .p_WB = {50.0, 0.0}});
  const BodyId stone =
      builder.add(Body{.name = "stone", .mobility = Mobility::particle, .mass = 1.0, .shape = Circle{0.1}});
  builder.add(Contact{.name = "hit", .a = post, .b = stone, .law = LinearSpringDashpot{1e10, 0.0, EndRule::clamped}});
  Scene scene{.title = "shot", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, stone, {speed, 0.0}, 0.0);
  return scene;
}

/// A bar that crosses a fixed one; their corners are far from each other if `height` is zero.
Scene crossed(double height, ContactMethod method) {
  ModelBuilder builder;
  const BodyId level =
      builder.add(Body{.name = "level", .mobility = Mobility::fixed, .shape = Rectangle{1.0, 0.1}, .p_WB = {0.0, 0.0}});
  const BodyId upright = builder.add(
      Body{.name = "upright", .mass = 1.0, .inertia = 1.0, .shape = Rectangle{0.1, 1.0}, .p_WB = {0.0, height}});
  builder.add(Contact{.name = "across",
                      .a = upright,
                      .b = level,
                      .law = LinearSpringDashpot{1.0, 0.0, EndRule::clamped},
                      .method = method});
  Scene scene{.title = "crossed", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  return scene;
}

/// An impact at v = 1 on a disc of radius 1 with overlap v/w.
Scene impact(double overlap) {
  const double w = 1.0 / overlap;
  return scenes::bouncing_disc(
      {.gap = 0.5, .speed = 1.0, .contact = LinearSpringDashpot{w * w, 0.0, EndRule::clamped}});
}

}  // namespace

BOOST_AUTO_TEST_CASE(instability_ends_a_run_before_its_first_step) {
  // Both springs act: the limit is h w = 2 with w = 100.
  BOOST_TEST(run(squeezed(), 0.01999, 0.2).violation.empty());
  const WatchedRun beyond = run(squeezed(), 0.02001, 0.2);
  BOOST_TEST(beyond.time == 0.0);
  BOOST_TEST(says(beyond.violation, "h omega = 2.001 > 2, the linear limit of velocity_verlet"));
  const WatchedRun warned = run(squeezed(), 0.02001, 0.2, "velocity_verlet",
                                {.instability = CheckAction::warning, .accuracy = CheckAction::off});
  BOOST_TEST(warned.violation.empty());
  BOOST_TEST(warned.warnings.size() == 1U);
  const WatchedRun off =
      run(squeezed(), 0.02001, 0.2, "velocity_verlet", {.instability = CheckAction::off, .accuracy = CheckAction::off});
  BOOST_TEST(off.warnings.empty());
  // Springs that do not act impose no limit.
  Scene apart = squeezed();
  apart.model.bodies[1].p_WB.y = -3.0, apart.model.bodies[2].p_WB.y = 3.0;
  BOOST_TEST(run(apart, 0.1, 1.0, "velocity_verlet", {.accuracy = CheckAction::off}).violation.empty());
}

BOOST_AUTO_TEST_CASE(bodies_that_could_pass_unseen_are_refused) {
  // Half the sum of 0.1 and 0.1 is a displacement of 0.1: at a step of 1e-3 a speed of 100.
  const MonitorRules rules{.instability = CheckAction::off, .accuracy = CheckAction::off};
  BOOST_TEST(run(shot(99.0), 1e-3, 0.1, "velocity_verlet", rules).violation.empty());
  const WatchedRun beyond = run(shot(101.0), 1e-3, 0.1, "velocity_verlet", rules);
  BOOST_TEST(beyond.time == 0.0);
  BOOST_TEST(says(beyond.violation, "the bodies of contact 'hit' may pass each other unseen"));
  // Methods with located steps need no such limit.
  BOOST_TEST(run(shot(101.0), 0.1, 0.1, "stormer_cowell", rules).violation.empty());
}

BOOST_AUTO_TEST_CASE(overlaps_are_measured_against_the_smaller_body) {
  const MonitorRules rules{.accuracy = CheckAction::error};
  BOOST_TEST(run(impact(0.249), 1e-4, 2.0).warnings.empty());
  const WatchedRun deep = run(impact(0.251), 1e-4, 2.0);
  BOOST_TEST(deep.violation.empty());
  BOOST_TEST(deep.warnings.size() == 1U);
  BOOST_TEST(deep.ratio == 0.251, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(!run(impact(0.251), 1e-4, 2.0, "velocity_verlet", rules).violation.empty());
  BOOST_TEST(run(impact(0.499), 1e-4, 3.0).violation.empty());
  const WatchedRun through = run(impact(0.501), 1e-4, 3.0);
  BOOST_TEST(says(through.violation, "the bodies may slip through each other"));
  BOOST_TEST(through.time < 1.4);
  // If both checks of the second limit only warn, each warning is given once, whatever the number of steps.
  const WatchedRun warned = run(impact(0.501), 1e-4, 3.0, "velocity_verlet",
                                {.tunnelling = CheckAction::warning, .accuracy = CheckAction::warning});
  BOOST_TEST(warned.violation.empty());
  BOOST_TEST(warned.warnings.size() == 2U);
}

BOOST_AUTO_TEST_CASE(outlines_that_cross_where_no_node_is_in_the_other) {
  const MonitorRules rules{.accuracy = CheckAction::off};
  const WatchedRun across = run(crossed(0.0, ContactMethod::nodes), 1e-3, 0.1, "velocity_verlet", rules);
  BOOST_TEST(across.time == 0.0);
  BOOST_TEST(says(across.violation, "no node of either is in the other"));
  BOOST_TEST(says(across.violation, "'across' overlaps by 11 of half the least width"));
  // With corners in the other bar, or with a single resultant, a force acts.
  const WatchedRun corners = run(crossed(1.08, ContactMethod::nodes), 1e-3, 0.1);
  BOOST_TEST(corners.violation.empty());
  BOOST_TEST(corners.ratio == 0.2, boost::test_tools::tolerance(1e-12));
  const WatchedRun resultant = run(crossed(0.0, ContactMethod::resultant), 1e-3, 0.1, "velocity_verlet", rules);
  BOOST_TEST(says(resultant.violation, "the bodies may slip through each other"));
  // Separate bodies, or a check that is off, cause no message.
  BOOST_TEST(run(crossed(1.2, ContactMethod::nodes), 1e-3, 0.1, "velocity_verlet", rules).violation.empty());
  const MonitorRules off{.tunnelling = CheckAction::off, .accuracy = CheckAction::off};
  BOOST_TEST(run(crossed(0.0, ContactMethod::nodes), 1e-3, 0.1, "velocity_verlet", off).violation.empty());
}

BOOST_AUTO_TEST_CASE(contacts_of_few_steps_are_warned_of_where_they_touch) {
  // Contact time pi/100.
  const Scene scene = impact(0.01);
  BOOST_TEST(run(scene, 0.0314, 0.4).warnings.empty());  // does not touch before t = 0.5
  const auto few = run(scene, std::acos(-1.0) / 100.0 / 9.9, 0.7).warnings;
  BOOST_TEST(!few.empty());
  BOOST_TEST(says(few.front(), "lasts 9.9 steps"));
  for (const std::string& other : run(scene, std::acos(-1.0) / 100.0 / 10.1, 0.7).warnings)
    BOOST_TEST(says(other, "energy balance"));
}

// A contact of pi sqrt(1/1e10) s: methods that choose their steps see its peak at the steps of the scene only.
BOOST_AUTO_TEST_CASE(outputs_that_miss_the_peaks_of_contacts_are_warned_of) {
  Scene scene = shot(1.0);
  const double time = std::acos(-1.0) * 1e-5;
  const Dynamics dynamics{scene.model};
  const auto warning = [&](const Integrator& integrator, double steps) {
    scene.integrator = integrator;
    scene.plan.step = time / steps;
    return output_warning(scene, dynamics);
  };
  BOOST_TEST(warning(make_integrator("stormer_cowell", 1e-10), 2.01) == "");
  BOOST_TEST(warning(make_integrator("velocity_verlet"), 0.5) == "");
  BOOST_TEST(
      warning(make_integrator("stormer_cowell", 1e-10), 0.5) ==
      "contact 'hit' lasts about 3.14e-05, 0.5 steps of the scene: stormer_cowell takes shorter ones itself, but "
      "largest overlaps and forces are those at the steps of the scene, and may be too small; a step of 1.57e-06 gives "
      "it 20");
}

BOOST_AUTO_TEST_CASE(a_ledger_that_does_not_close_is_warned_of) {
  // The energy of an oscillation by Euler-Cromer is off by h w/2 at first order, back and forth.
  Scene swings = squeezed();
  set_velocity(swings.model, swings.initial, static_cast<BodyId>(0), {0.0, 0.1}, 0.0);
  MonitorRules rules;
  rules.tunnelling = CheckAction::off;
  const auto coarse = run(swings, 0.003, 0.3, "euler_cromer", rules).warnings;
  BOOST_TEST(coarse.size() == 1U);
  if (!coarse.empty()) BOOST_TEST(says(coarse.front(), "the energy balance is off by"));
  BOOST_TEST(run(swings, 0.00003, 0.3, "euler_cromer", rules).warnings.empty());
}

BOOST_AUTO_TEST_CASE(a_watch_put_back_goes_on) {
  Scene scene = impact(0.251);
  scene.integrator = make_integrator("velocity_verlet");
  scene.plan = {1e-3, 1.5, 1.5, true, {}};
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, true};
  State state = scene.initial;
  RunMonitor watch{scene, dynamics, state}, other{scene, dynamics, state};
  long n = 0;
  static_cast<void>(simulate(system, scene.integrator, state, scene.plan, {}, [&](const Snapshot& seen) {
    watch.check(seen, ++n);
    return false;
  }));
  BOOST_TEST(watch.warnings().size() == 1U);
  Archive saving;
  watch.serialize(saving);
  Archive putting_back{saving.items()};
  other.serialize(putting_back);
  BOOST_TEST((other.warnings() == watch.warnings()));
  BOOST_TEST(other.extreme(Watched::overlap).value == watch.extreme(Watched::overlap).value);
  BOOST_TEST(other.extreme(Watched::overlap).time == watch.extreme(Watched::overlap).time);
}

// A scene with one contact, number 0, and the same scene without it, where an extreme at a contact is invalid.
BOOST_AUTO_TEST_CASE(an_extreme_of_a_contact_that_is_not_there_is_refused) {
  Scene one = impact(0.251);
  one.integrator = make_integrator("velocity_verlet");
  one.plan = {1e-3, 1.0, 1.0, true};
  Scene none = one;
  none.model.contacts.clear();
  none.initial = rest_state(none.model);
  for (const Scene& scene : std::array{one, none}) {
    const Dynamics dynamics{scene.model};
    const State start = scene.initial;
    for (const auto which : {Watched::frequency, Watched::overlap, Watched::contact}) {
      RunMonitor watch{scene, dynamics, start};
      Archive saving;
      watch.serialize(saving);
      ArchiveItems kept = saving.items();
      const std::size_t first = 5 * static_cast<std::size_t>(which);
      auto& numbers = std::get<std::vector<double>>(kept.at("extremes"));
      numbers[first + 3] = 1.0;  // a value has been found
      const auto is_loading = [&](double contact) {
        numbers[first + 2] = contact;
        Archive putting_back{kept};
        try {
          RunMonitor{scene, dynamics, start}.serialize(putting_back);
        } catch (const InputError&) {
          return false;
        }
        return true;
      };
      BOOST_TEST(is_loading(0.0) == (!scene.model.contacts.empty() || which == Watched::frequency));
      BOOST_TEST(!is_loading(1.0));
      BOOST_TEST(!is_loading(-1.0));
    }
  }
}

// Overlaps of the start are known before the first step, and not reported again.
BOOST_AUTO_TEST_CASE(bodies_that_overlap_at_the_start_are_reported_by_the_constructor) {
  Scene scene = impact(0.251);
  scene.integrator = make_integrator("velocity_verlet");
  scene.plan = {1e-3, 1.0, 1.0, true};
  scene.model.contacts.clear();
  for (const bool overlaps : {false, true}) {
    if (overlaps) scene.model.bodies[0].p_WB = scene.model.bodies[1].p_WB;
    scene.initial = rest_state(scene.model);
    for (const CheckAction action : {CheckAction::warning, CheckAction::error}) {
      scene.plan.watch.missing_contacts = action;
      const Dynamics dynamics{scene.model};
      RunMonitor watch{scene, dynamics, scene.initial};
      const bool warns = overlaps && action == CheckAction::warning;
      BOOST_TEST(watch.start_warnings().size() == (warns ? 1U : 0U));
      BOOST_TEST(watch.violation().empty() == (!overlaps || action == CheckAction::warning));
      watch.check(Snapshot{dynamics, scene.initial}, 0);
      BOOST_TEST(watch.warnings() == watch.start_warnings());
      if (warns) BOOST_TEST(says(watch.warnings()[0], "no [[contact]] is declared between them"));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
