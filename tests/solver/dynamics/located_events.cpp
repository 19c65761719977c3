/// Events that a method locates (solver/integrate/stormer_cowell.hpp), where they are most easily missed: at the ends
/// of steps, simultaneous, grazing, accumulating.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/scene.hpp"

BOOST_AUTO_TEST_SUITE(located_events_tests)

using namespace talus;

namespace {

constexpr double stiffness = 1e4;

/// Discs of mass and radius 1 above the ground, side by side, each with its own gap; gravity 2.
Model discs(const std::vector<double>& gaps, double damping = 0.0, double gravity = 2.0) {
  ModelBuilder builder;
  builder.gravity({0.0, -gravity});
  const BodyId ground = builder.add(Body{.name = "ground", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const BodyId disc = builder.add(Body{.name = "disc" + std::to_string(i),
                                         .mobility = Mobility::particle,
                                         .mass = 1.0,
                                         .shape = Circle{1.0},
                                         .p_WB = {10.0 * static_cast<double>(i), 1.0 + gaps[i]}});
    builder.add(Contact{.name = "contact" + std::to_string(i),
                        .a = ground,
                        .b = disc,
                        .law = LinearSpringDashpot{stiffness, damping, EndRule::clamped}});
  }
  return builder.build();
}

struct Ran {
  State state;
  long events{};
  long evaluations{};
  Outcome outcome;
};

/// Runs a model; tolerance 0 selects the exact propagator.
Ran run(const Model& model, double end, long steps, double tolerance, std::vector<double> speeds = {}) {
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics, false};
  State state = rest_state(model);
  for (std::size_t i = 0; i < speeds.size(); ++i)
    set_velocity(model, state, static_cast<BodyId>(i + 1), {0.0, speeds[i]}, 0.0);
  Integrator method = tolerance > 0.0 ? make_integrator("stormer_cowell", tolerance) : make_integrator("exact");
  const double step = end / static_cast<double>(steps);
  const Outcome outcome = simulate(system, method, state, {step, end, step, false});
  return {state, located_events(method).value(), system.evaluations(), outcome};
}

/// Half the duration of an undamped contact with impact speed v under gravity g: the overlap is y = g/k + A sin(w (t -
/// t0)) ..., half of its duration (pi/2 + atan(g/(w v)))/w.
double half_contact(double v, double g) {
  const double w = std::sqrt(stiffness);
  return (0.5 * std::acos(-1.0) + std::atan(g / (w * v))) / w;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_event_at_the_very_end_of_an_output_step) {
  // Gap 1 under gravity 2: first contact at t = 1, a multiple of the step; after the contact the same time back to rest
  // at the initial gap.
  const double end = 2.0 + 2.0 * half_contact(2.0, 2.0);
  for (const double tolerance : {1e-12, 0.0}) {
    for (const long steps : {1L, 4L, 64L}) {
      BOOST_TEST_INFO_SCOPE("tolerance " << tolerance << ", steps " << steps);
      const Model model = discs({1.0});
      const Ran all = run(model, 1.0, steps, tolerance);
      BOOST_TEST(all.state.q[1] == 1.0, boost::test_tools::tolerance(1e-14));
      BOOST_TEST(all.state.v[1] == -2.0, boost::test_tools::tolerance(1e-14));
      const Ran back = run(model, end, steps, tolerance);
      BOOST_TEST(back.state.q[1] == 2.0, boost::test_tools::tolerance(1e-11));
      BOOST_TEST(std::abs(back.state.v[1]) < 1e-9);
      // The last step may extend beyond the end, to the next contact.
      BOOST_TEST(back.events >= 2);
      BOOST_TEST(back.events <= (tolerance > 0.0 ? 2 : 3));
    }
  }
}

BOOST_AUTO_TEST_CASE(an_event_in_the_first_step) {
  for (const double gap : {0.0, 1e-15, 1e-9}) {
    const double v = std::sqrt(0.25 + 4.0 * gap), fall = (v - 0.5) / 2.0;
    const double end = fall + 2.0 * half_contact(v, 2.0) + fall;
    for (const double tolerance : {1e-12, 0.0}) {
      const Ran found = run(discs({gap}), end, 1, tolerance, {-0.5});
      BOOST_TEST(found.state.q[1] == 1.0 + gap, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(found.state.v[1] == 0.5, boost::test_tools::tolerance(1e-10));
    }
  }
}

BOOST_AUTO_TEST_CASE(events_at_one_time) {
  for (const double tolerance : {1e-10, 0.0}) {
    const Ran one = run(discs({0.3}), 3.0, 10, tolerance);
    const Ran three = run(discs({0.3, 0.3, 0.3}), 3.0, 10, tolerance);
    BOOST_TEST(three.events == one.events);
    BOOST_TEST(three.evaluations == one.evaluations);
    for (const std::size_t i : {1U, 3U, 5U})
      BOOST_TEST(three.state.q[i] == one.state.q[1]);
  }
}

BOOST_AUTO_TEST_CASE(events_almost_at_one_time) {
  for (const double tolerance : {1e-11, 0.0}) {
    const Ran apart = run(discs({0.3, 0.3 + 1e-13}), 3.0, 10, tolerance);
    BOOST_TEST(apart.state.q[1] == apart.state.q[3], boost::test_tools::tolerance(1e-9));
    BOOST_TEST(static_cast<bool>(apart.outcome));
  }
}

BOOST_AUTO_TEST_CASE(grazing) {
  // Thrown down from a gap of 1 against an upward acceleration of 2: the turning point is exactly at the ground, 1e-9
  // above it, or below it.
  for (const double beyond : {-1e-9, 0.0, 1e-9, 1e-4}) {
    const double speed = 2.0 * std::sqrt(1.0 + beyond);
    for (const double tolerance : {1e-12, 0.0}) {
      const Ran found = run(discs({1.0}, 0.0, -2.0), speed, 3, tolerance, {-speed});
      BOOST_TEST(static_cast<bool>(found.outcome));
      // Without contact it would return to its position with its speed; a contact with overlap `beyond` turns it
      // earlier, by at most 2 sqrt(beyond) of speed over an acceleration of 2, and displaces it by that times its
      // speed.
      const double early = 2.0 * std::sqrt(std::max(beyond, 0.0));
      BOOST_TEST(found.state.q[1] >= 2.0 - 1e-9);
      BOOST_TEST(found.state.q[1] <= 2.0 + early * speed + 1e-9);
      if (beyond == 1e-4) BOOST_TEST(found.events == 2);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_cable_taut_for_a_moment) {
  // As in grazing, but the particle is turned by a cable from the origin, of length 2: taut only within a step.
  for (const double beyond : {-1e-9, 0.0, 1e-9, 1e-4}) {
    ModelBuilder builder;
    builder.gravity({-2.0, 0.0});
    const BodyId particle =
        builder.add(Body{.name = "particle", .mobility = Mobility::particle, .mass = 1.0, .p_WB = {1.0, 0.0}});
    builder.add(Cable{.name = "cable",
                      .a = {std::nullopt, {0.0, 0.0}},
                      .b = {particle, {}},
                      .rest_length = 2.0,
                      .law = TensionOnly{stiffness}});
    const Model model = builder.build();
    const Dynamics dynamics{model};
    RigidBodySystem system{dynamics, false};
    State state = rest_state(model);
    const double speed = 2.0 * std::sqrt(1.0 + beyond);
    set_velocity(model, state, particle, {speed, 0.0}, 0.0);
    Integrator method = make_integrator("stormer_cowell", 1e-12);
    BOOST_TEST_REQUIRE(static_cast<bool>(simulate(system, method, state, {speed / 3.0, speed, speed / 3.0, false})));
    const double early = 2.0 * std::sqrt(std::max(beyond, 0.0));
    BOOST_TEST(state.q[0] <= 1.0 + 1e-9);
    BOOST_TEST(state.q[0] >= 1.0 - early * speed - 1e-9);
    if (beyond == 1e-4) BOOST_TEST(located_events(method).value() == 2);
  }
}

BOOST_AUTO_TEST_CASE(bounces_to_rest_come_to_an_end) {
  const double damping = 0.4 * std::sqrt(stiffness);
  const Ran found = run(discs({0.5}, damping), 30.0, 30, 1e-8);
  BOOST_TEST(static_cast<bool>(found.outcome));
  BOOST_TEST(found.state.q[1] == 1.0 - 2.0 / stiffness, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::abs(found.state.v[1]) < 1e-6);
  BOOST_TEST(found.events > 5);
  // 848 evaluations: some 20 for each of 19 events, and the decay in the last contact. At rest, stability would limit
  // explicit steps to less than a radian of the contact's oscillation, 3,630 steps for the 3,000 radians: the steps are
  // implicit.
  BOOST_TEST(found.evaluations < 1000);
}

BOOST_AUTO_TEST_CASE(a_fast_body_does_not_pass_another_unseen) {
  // `exact` takes whole intervals except at the post, and with a ledger ends steps at outputs. Ten of the longest steps
  // fall short of the first output by the rounding of their sum: a step of that length precedes the one to the post.
  for (const std::string method : {"stormer_cowell", "exact"}) {
    for (const bool ledger : {false, true}) {
      for (const double speed : {1.0, 300.0}) {
        ModelBuilder builder;
        const BodyId post =
            builder.add(Body{.name = "post", .mobility = Mobility::fixed, .shape = Circle{0.1}, .p_WB = {1.5, 0.0}});
        const BodyId stone =
            builder.add(Body{.name = "stone", .mobility = Mobility::sliding_x, .mass = 1.0, .shape = Circle{0.1}});
        builder.add(
            Contact{.name = "hit", .a = post, .b = stone, .law = LinearSpringDashpot{1e8, 0.0, EndRule::clamped}});
        const Model model = builder.build();
        const Dynamics dynamics{model};
        RigidBodySystem system{dynamics, ledger};
        State state = rest_state(model);
        set_velocity(model, state, stone, {speed, 0.0}, 0.0);
        Integrator integrator = method == "exact" ? make_integrator(method) : make_integrator(method, 1e-9);
        BOOST_TEST(
            static_cast<bool>(simulate(system, integrator, state, {1.0 / speed, 4.0 / speed, 1.0 / speed, ledger})));
        BOOST_TEST(state.v[0] == -speed, boost::test_tools::tolerance(1e-7));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(nor_does_one_that_a_force_sets_in_motion) {
  ModelBuilder builder;
  const BodyId post =
      builder.add(Body{.name = "post", .mobility = Mobility::fixed, .shape = Circle{0.01}, .p_WB = {1.3, 0.0}});
  const BodyId stone = builder.add(
      Body{.name = "stone", .mobility = Mobility::particle, .mass = 1.0, .shape = Circle{0.01}, .force = {1.0, 0.0}});
  builder.add(Contact{.name = "hit", .a = post, .b = stone, .law = LinearSpringDashpot{1e8, 0.0, EndRule::clamped}});
  const Model model = builder.build();
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics, false};
  State state = rest_state(model);
  Integrator method = make_integrator("stormer_cowell", 1e-9);
  // It reaches the post at t = 1.6 s and is back before 3.25 s.
  BOOST_TEST(static_cast<bool>(simulate(system, method, state, {1.0, 3.0, 1.0, false})));
  BOOST_TEST(state.q[0] < 1.28);
  BOOST_TEST(state.v[0] < 0.0);
}

BOOST_AUTO_TEST_CASE(what_cannot_go_on_says_why) {
  // A force that is NaN from the first elongation on: no step is short enough.
  ModelBuilder builder;
  const BodyId disc = builder.add(Body{.name = "disc", .mobility = Mobility::particle, .mass = 1.0});
  builder.add(Cable{.name = "cable",
                    .a = {disc, {}},
                    .b = {std::nullopt, {0.0, 1.0, 0.0}},
                    .rest_length = 1.0,
                    .law = TensionOnly{1e300, 1e300}});
  const Model model = builder.build();
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics, false};
  State state = rest_state(model);
  set_velocity(model, state, disc, {0.0, -1e20}, 0.0);
  Integrator method = make_integrator("stormer_cowell", 1e-9);
  const Outcome outcome = simulate(system, method, state, {1.0, 1.0, 1.0, false});
  BOOST_TEST(!static_cast<bool>(outcome));
  BOOST_TEST(outcome.message.find("t = ") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
