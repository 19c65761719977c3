/// A run that is stopped, saved and resumed by new objects ends with the bits of an uninterrupted run: every integrator
/// of the closed list, several scenes, several stops.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

#include "solver/base/error.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/failure_log.hpp"
#include "solver/run/history.hpp"
#include "solver/run/run_state.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "solver/scenes/pendulum.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/scenes/two_cable.hpp"
#include "tests/solver/scenes/sample_fence.hpp"

BOOST_AUTO_TEST_SUITE(run_state_tests)

using namespace talus;

namespace {

/// Results of a run.
struct Left {
  State state;
  State held;
  long evaluations{};
  std::vector<std::vector<double>> rows;
  std::vector<double> extremes{};
  std::vector<double> balance_errors{};
  std::string failures{};
};

/// A run with its recorder, constructed again for each leg of the run.
class Leg {
 public:
  explicit Leg(const Scene& scene)
      : plan_{scene.plan},
        dynamics_{scene.model},
        system_{dynamics_, plan_.ledger},
        run_state_{initial_run_state(scene.integrator, started(scene.initial))},
        recorder_{dynamics_, run_state_.state, plan_.ledger},
        failures_{dynamics_} {}

  /// Continues to this step.
  void run_to(long step) {
    const Observer observers[] = {[this](const Snapshot& seen, const StepInfo& info) {
      recorder_(seen, info);
      failures_(seen.state(), info);
    }};
    const double end = run_state_.start + static_cast<double>(step) * plan_.step;
    const StopCondition stop = [end](const State& seen) { return seen.t >= end; };
    const Outcome outcome = simulate(system_, run_state_, plan_, observers, stop);
    BOOST_TEST_REQUIRE(static_cast<bool>(outcome), outcome.message);
    BOOST_TEST(run_state_.step == step);
  }

  void serialize(Archive& archive) {
    archive.scope("run", [&] { run_state_.serialize(archive); });
    archive.scope("recorder", [&] { recorder_.serialize(archive); });
    archive.scope("failures", [&] { failures_.serialize(archive); });
  }

  Left left() {
    Left all{.state = synchronized(run_state_, system_, plan_),
             .held = run_state_.state,
             .evaluations = run_state_.evaluations,
             .rows = recorder_.history().rows};
    for (std::size_t i = 0; i < recorder_.row().size(); ++i) {
      const Extreme e = recorder_.extreme(i);
      all.extremes.insert(all.extremes.end(), {e.minimum, e.minimum_time, e.maximum, e.maximum_time});
    }
    for (const Failure& failure : failures_.failures())
      all.failures += failure.part + " " + std::string{failure.what} + " at " + std::to_string(failure.time) + "\n";
    const Accounts& accounts = recorder_.accounts();
    all.balance_errors = {accounts.energies.total(),
                          accounts.total_dissipated(),
                          accounts.energy_balance_error,
                          accounts.momentum_balance_error.x,
                          accounts.momentum_balance_error.y,
                          accounts.angular_momentum_balance_error,
                          recorder_.ledger()->largest_energy_balance_error(),
                          recorder_.ledger()->energy_scale()};
    return all;
  }

 private:
  State started(State state) {
    system_.begin(state);
    return state;
  }

  RunPlan plan_;
  Dynamics dynamics_;
  RigidBodySystem system_;
  RunState run_state_;
  Recorder recorder_;
  FailureLog failures_;
};

void same_bits(const Left& one, const Left& other) {
  BOOST_TEST((one.state == other.state));
  BOOST_TEST((one.held == other.held));
  BOOST_TEST(one.evaluations == other.evaluations);
  BOOST_TEST((one.rows == other.rows));
  BOOST_TEST((one.extremes == other.extremes));
  BOOST_TEST((one.balance_errors == other.balance_errors));
  BOOST_TEST(one.failures == other.failures);
}

/// Compares an uninterrupted run with runs that stop at these steps, each leg resumed by new objects.
void stopped_runs_end_alike(const Scene& scene, const std::vector<std::vector<long>>& all_stops) {
  const long steps = step_count(scene.plan);
  Leg whole{scene};
  whole.run_to(steps);
  const Left wanted = whole.left();
  for (const std::vector<long>& stops : all_stops) {
    BOOST_TEST_CONTEXT("first stop after step " << stops.front() << " of " << steps) {
      ArchiveItems kept;
      {
        Leg first{scene};
        first.run_to(stops.front());
        Archive saving;
        first.serialize(saving);
        kept = saving.items();
      }
      for (std::size_t i = 1; i <= stops.size(); ++i) {
        Leg next{scene};
        Archive putting_back{kept};
        next.serialize(putting_back);
        BOOST_TEST(putting_back.left_over().empty());
        next.run_to(i < stops.size() ? stops[i] : steps);
        if (i == stops.size()) same_bits(next.left(), wanted);
        Archive saving;
        next.serialize(saving);
        kept = saving.items();
      }
    }
  }
}

/// Each integrator of the list, with fixed steps and, where available, with step control.
std::vector<Integrator> all_integrators() {
  std::vector<Integrator> made;
  for (const std::string& known : integrator_names()) {
    for (const double tolerance : {0.0, 1e-9}) {
      try {
        made.push_back(make_integrator(known, tolerance));
      } catch (const InputError&) {  // it supports only the other
      }
    }
  }
  return made;
}

void every_integrator(Scene scene, long steps, const std::vector<std::vector<long>>& all_stops) {
  scene.plan.end = static_cast<double>(steps) * scene.plan.step;
  scene.plan.interval = 7.0 * scene.plan.step;
  scene.plan.ledger = true;
  for (const Integrator& integrator : all_integrators()) {
    BOOST_TEST_CONTEXT(scene.title << ", " << name(integrator)) {
      scene.integrator = integrator;
      stopped_runs_end_alike(scene, all_stops);
    }
  }
}

/// sample2 of the manual (Mustoe & Huttelmaier 1993, Appendix II.5.1) with a top cable that yields, hangers that break
/// soon after the impact, and friction.
scenes::FenceScene yielding_fence() {
  scenes::Fence fence = scenes::sample2();
  fence.steps = 400;
  fence.friction = 0.4;
  fence.options.hanger_strength = 8000.0;
  fence.limit_top = 4e4;
  return scenes::fence_scene(fence);
}

const LinearSpringDashpot contact{1e5, 300.0, EndRule::clamped};

}  // namespace

BOOST_AUTO_TEST_CASE(two_cables) {
  Scene scene = scenes::two_cable({.contact = contact});
  scene.plan.step = 1e-3;
  // Contact lasts until step 15; the cables become slack and taut again later.
  every_integrator(scene, 400, {{1}, {2, 3}, {5}, {14, 15, 16}, {399}, {400}});
}

BOOST_AUTO_TEST_CASE(pivoted_cylinder_with_nodes) {
  Scene scene = scenes::pivoted_cylinder({.rock_radius = 1.5, .contact = contact, .method = ContactMethod::nodes});
  scene.plan.step = 2e-4;
  every_integrator(scene, 400, {{1}, {30, 31}, {150}, {399}, {400}});
}

// Intervals of many internal steps: here the data that step control carries from one to the next matters.
BOOST_AUTO_TEST_CASE(pendulum_with_long_intervals) {
  Scene scene = scenes::cable_pendulum({.amplitude = 1.0});
  scene.plan = {.step = 0.1, .end = 10.0, .interval = 0.3};
  std::vector<long> everywhere(99);
  std::iota(everywhere.begin(), everywhere.end(), 1L);
  for (const Integrator& integrator : all_integrators()) {
    if (tolerance(integrator) == 0.0) continue;
    BOOST_TEST_CONTEXT(name(integrator)) {
      scene.integrator = integrator;
      stopped_runs_end_alike(scene, {everywhere});
    }
  }
}

BOOST_AUTO_TEST_CASE(fence_that_yields_breaks_and_rubs_with_sleeping_columns) {
  const scenes::FenceScene made = yielding_fence();
  const Layout layout{made.scene.model};
  Leg whole{made.scene};
  whole.run_to(5);
  const std::vector<Mode> early = whole.left().state.mode;
  const auto sleepers = early.begin() + static_cast<std::ptrdiff_t>(layout.first_sleeper);
  BOOST_TEST(std::count(sleepers, early.end(), Mode{0}) > 0);
  BOOST_TEST(std::count(sleepers, early.end(), Mode{1}) > 0);
  whole.run_to(250);
  const Left end = whole.left();
  BOOST_TEST(end.state.work[static_cast<std::size_t>(Mechanism::cable_yield)] > 0.0);
  BOOST_TEST(end.state.work[static_cast<std::size_t>(Mechanism::friction)] > 0.0);
  BOOST_TEST(end.failures.find("hanger 'hanger1' breaks") != std::string::npos);
  every_integrator(made.scene, 250, {{1}, {2}, {5, 6, 7}, {40, 41}, {120, 200}, {249}});
}

BOOST_AUTO_TEST_CASE(what_is_put_back_must_fit) {
  Scene scene = scenes::two_cable({.contact = contact});
  scene.plan = {.step = 1e-3, .end = 0.1, .interval = 0.01};
  scene.integrator = make_integrator("velocity_verlet");
  Leg first{scene};
  first.run_to(10);
  Archive saving;
  first.serialize(saving);
  const auto message = [&](const char* item, std::variant<std::vector<double>, std::string> value) {
    ArchiveItems kept = saving.items();
    BOOST_REQUIRE(kept.contains(item));
    kept[item] = std::move(value);
    Leg next{scene};
    Archive putting_back{kept};
    try {
      next.serialize(putting_back);
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  BOOST_TEST(message("run.state.q", std::vector{1.0}) == "run.state.q: found 1 numbers; it must have 4");
  BOOST_TEST(message("run.velocity_verlet.rates.v", std::string{"x"}) ==
             "run.velocity_verlet.rates.v: found a text; it must be a list of numbers");
  BOOST_TEST(message("run.step", std::vector{1.5}) ==
             "run.step: found 1.5; it must be a whole number from 0 to 9007199254740992");
  BOOST_TEST(message("run.state.mode", std::vector{0.0, 0.0, 65536.0}) ==
             "run.state.mode[2]: found 65536; it must be a whole number from 0 to 65535");
  BOOST_TEST(message("recorder.history.rows", std::vector{1.0}).starts_with("rows: found 1 numbers; it must be whole"));
  ArchiveItems kept = saving.items();
  kept.erase("run.start");
  Leg next{scene};
  Archive putting_back{kept};
  BOOST_CHECK_EXCEPTION(next.serialize(putting_back), InputError, [](const InputError& error) {
    return std::string{error.what()} == "run.start: it is missing; it must be a list of numbers";
  });
}

BOOST_AUTO_TEST_SUITE_END()
