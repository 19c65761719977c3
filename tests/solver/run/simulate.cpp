#include "solver/run/simulate.hpp"
#include "solver/base/error.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/model/model_builder.hpp"
#include "solver/run/history.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/run/turning_point.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pendulum.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(simulate_tests)

using namespace talus;

namespace {

struct Run {
  Outcome outcome;
  State state;
  History history;
  double balance_error;
};

Run run(const Scene& scene) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, scene.plan.ledger};
  Recorder recorder{dynamics, scene.initial};
  State state = scene.initial;
  Integrator integrator = scene.integrator;
  const Observer observer = std::ref(recorder);
  Outcome outcome = simulate(system, integrator, state, scene.plan, {&observer, 1});
  return {outcome, state, recorder.history(),
          recorder.ledger()->largest_energy_balance_error() / recorder.ledger()->energy_scale()};
}

Scene bounce(EndRule rule, const char* integrator, double step) {
  Scene scene = scenes::bouncing_disc(
      {.gap = 0.25, .speed = 0.0, .gravity = 9.81, .contact = LinearSpringDashpot{1e4, 40.0, rule}});
  scene.integrator = make_integrator(integrator);
  scene.plan = {step, 1.0, 0.1, true};
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(ledger_closes_at_first_order_through_bounces_with_both_end_rules) {
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    for (const char* integrator : {"central_difference", "velocity_verlet", "euler_cromer", "rk4"}) {
      BOOST_TEST_CONTEXT(integrator) {
        const double coarse = run(bounce(rule, integrator, 1e-4)).balance_error;
        const double fine = run(bounce(rule, integrator, 1e-5)).balance_error;
        // The force jump of a dashpot at first contact is integrated up to a step late: v c v h relative to v^2/2 is 2
        // c h = 8e-3 at 1e-4.
        BOOST_TEST(coarse < 4e-2);
        BOOST_TEST(fine < 4e-3);
        BOOST_TEST(fine > 0.0);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(ledger_off_changes_no_motion) {
  for (const std::string& known : integrator_names()) {
    for (const double tolerance : {0.0, 1e-8}) {
      Scene scene = bounce(EndRule::clamped, "velocity_verlet", 1e-3);
      try {
        scene.integrator = make_integrator(known, tolerance);
      } catch (const InputError&) {
        continue;  // this method has no step control, or no fixed step
      }
      BOOST_TEST_CONTEXT(known << ", tolerance " << tolerance) {
        const Run with = run(scene);
        scene.plan.ledger = false;
        const Run without = run(scene);
        if (needs_closed_form(known)) {
          // With a ledger its steps end at outputs, where the sums of its series are rounded; the speed is 1e-4,
          // compared with 1 before, close to the turning point.
          BOOST_TEST(with.state.q == without.state.q, boost::test_tools::tolerance(1e-13)
                                                          << boost::test_tools::per_element());
          BOOST_TEST(with.state.v == without.state.v, boost::test_tools::tolerance(1e-9)
                                                          << boost::test_tools::per_element());
          continue;
        }
        BOOST_TEST(with.state.q == without.state.q);
        BOOST_TEST(with.state.v == without.state.v);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(histories_show_no_cable_that_pushes_and_no_clamped_contact_that_pulls) {
  ModelBuilder builder;
  builder.gravity({0.0, -9.81});
  const BodyId bob = builder.add(Body{.name = "bob", .mobility = Mobility::particle, .mass = 1.0, .p_WB = {0.0, -0.5}});
  builder.add(Cable{
      .name = "cable", .a = {bob, {}}, .b = {std::nullopt, {}}, .rest_length = 1.0, .law = TensionOnly{1e3, 5.0}});
  Scene hung{.title = "hung bob", .model = builder.build()};
  hung.initial = rest_state(hung.model);
  hung.plan = {5e-3, 3.0, 5e-3, true};
  for (const char* known : {"central_difference", "velocity_verlet", "euler_cromer", "rk4", "odeint_dopri5"}) {
    for (Scene scene : {hung, bounce(EndRule::clamped, known, 2e-3)}) {
      scene.integrator = make_integrator(known);
      scene.plan.interval = scene.plan.step;
      const Run done = run(scene);
      for (std::size_t c = 0; c < done.history.columns.size(); ++c) {
        const std::string& column = done.history.columns[c].name;
        if (column != "cable.tension" && column != "impact.force") continue;
        double smallest = 0.0, largest = 0.0;
        for (const auto& row : done.history.rows)
          smallest = std::min(smallest, row[c]), largest = std::max(largest, row[c]);
        BOOST_TEST(smallest >= 0.0);
        BOOST_TEST(largest > 0.0);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(observers_change_nothing) {
  const Scene scene = bounce(EndRule::clamped, "rk4", 1e-3);
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics};
  State alone = scene.initial;
  Integrator integrator = scene.integrator;
  BOOST_TEST(static_cast<bool>(simulate(system, integrator, alone, scene.plan)));
  BOOST_TEST((alone == run(scene).state));
}

BOOST_AUTO_TEST_CASE(history_has_first_and_last_state_and_whole_intervals) {
  const Run done = run(bounce(EndRule::clamped, "velocity_verlet", 1e-3));
  BOOST_REQUIRE(done.history.rows.size() == 11);
  BOOST_TEST(done.history.columns[0].name == "time");
  BOOST_TEST(done.history.rows[0][0] == 0.0);
  BOOST_TEST(done.history.rows[1][0] == 0.1, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(done.history.rows.back()[0] == 1.0, boost::test_tools::tolerance(1e-15));
  for (const auto& row : done.history.rows)
    BOOST_TEST(row.size() == done.history.columns.size());
}

BOOST_AUTO_TEST_CASE(a_run_that_grows_without_bound_is_a_result_with_time_and_reason) {
  // Held between two cables that remain taut, h w = 0.05 sqrt(2e4) = 7 > 2: each step multiplies the motion by about
  // 50.
  ModelBuilder builder;
  const BodyId bead = builder.add(Body{.name = "bead", .mobility = Mobility::particle, .mass = 1.0});
  for (const double end : {-1.0, 1.0}) {
    builder.add(Cable{.name = end < 0.0 ? "left" : "right",
                      .a = {bead, {}},
                      .b = {std::nullopt, {end, 0.0, 0.0}},
                      .rest_length = 0.0,
                      .law = TensionOnly{1e4, 0.0}});
  }
  Scene scene{.title = "held bead", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  scene.initial.q[0] = 1e-6;
  scene.integrator = VelocityVerlet{};
  scene.plan = {0.05, 100.0, 1.0, true};
  const Run done = run(scene);
  BOOST_TEST((done.outcome.kind == Outcome::Kind::diverged));
  BOOST_TEST(done.outcome.time > 1.0);
  BOOST_TEST(done.outcome.time < 20.0);
  BOOST_TEST(done.outcome.message.find("'bead.x' is not finite (step 0.05 s)") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(step_count_reaches_the_end_and_forgives_round_off) {
  BOOST_TEST(step_count({0.1, 1.0, 1.0, true}) == 10);
  BOOST_TEST(step_count({0.3, 1.0, 1.0, true}) == 4);
  BOOST_TEST(step_count({1e-3, 2.5, 1.0, true}) == 2500);
}

BOOST_AUTO_TEST_CASE(turning_point_lies_between_steps_at_fourth_order) {
  // A body thrown up: q = 2 t - 5 t^2 turns at t = 0.2, q = 0.2; the cubic interpolation is exact for a parabola.
  TurningPointFinder finder{0};
  for (int i = 0; i < 4; ++i) {
    const double t = 0.15 * i;
    State state;
    state.t = t, state.q = {2.0 * t - 5.0 * t * t}, state.v = {2.0 - 10.0 * t};
    finder(state, {i, 0, true});
  }
  BOOST_REQUIRE(finder.found().has_value());
  BOOST_TEST(finder.found()->time == 0.2, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(finder.found()->value == 0.2, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(central_difference_shows_observers_one_time) {
  // The energy of a pendulum from synchronized values is of second order; from the staggered ones only of first.
  Scene scene = scenes::pendulum({.amplitude = 1.0});
  scene.integrator = CentralDifference{};
  scene.plan = {1e-3, 1.0, 1.0, true};
  BOOST_TEST(run(scene).balance_error < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
