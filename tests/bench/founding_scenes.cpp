/// Microseconds per step of each founding scene, and work-precision tables with times: medians of interleaved
/// repetitions, and ratios within this one run.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/laws/restitution.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/run/turning_point.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pendulum.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/scenes/two_cable.hpp"
#include "tests/bench/contact_search.hpp"
#include "tests/bench/fences.hpp"
#include "tests/bench/located_events.hpp"
#include "tests/bench/reading.hpp"
#include "tests/bench/structure.hpp"
#include "tests/bench/timing.hpp"
#include "tests/bench/user_runs.hpp"
#include "verification/reference/cables/two_cable.hpp"
#include "verification/reference/motion/pendulum.hpp"

namespace {

using namespace talus;
constexpr int repetitions = 15;

struct Run {
  State end;
  long evaluations{};
};

/// Runs the scene for `steps` steps, without observers.
Run advanced(const Scene& scene, const Dynamics& dynamics, Integrator integrator, double step, long steps,
             bool ledger) {
  RigidBodySystem system{dynamics, ledger};
  State state = scene.initial;
  const Outcome outcome = simulate(system, integrator, state, {step, step * static_cast<double>(steps), 1e300, ledger});
  if (!outcome) fmt::print("  {}\n", outcome.message);
  return {state, system.evaluations()};
}

/// A founding scene with a step of a hundredth of its contact time or period.
struct Named {
  std::string name;
  Scene scene;
  double step{};
};
std::vector<Named> founding_scenes() {
  const LinearSpringDashpot law{1e4, 20.0, EndRule::attractive};
  const LinearSpringDashpot stiff{1e6, 1e3, EndRule::attractive};
  scenes::PivotedCylinder nodal{.contact = stiff};
  nodal.method = ContactMethod::nodes;
  return {{"two_cable", scenes::two_cable({.contact = law}), 2.6e-4},
          {"pivoted_cylinder", scenes::pivoted_cylinder({.contact = stiff}), 1e-4},
          {"pivoted_cylinder, 12 nodes", scenes::pivoted_cylinder(nodal), 1e-4},
          {"bouncing_disc", scenes::bouncing_disc({.gap = 0.1, .gravity = 9.81, .contact = law}), 3e-4},
          {"pendulum", scenes::pendulum({.amplitude = 1.5}), 0.02},
          {"cable_pendulum", scenes::cable_pendulum({}), 6e-4}};
}

void print_step_costs() {
  constexpr long steps = 2000;
  const std::vector<Named> scenes = founding_scenes();
  const std::vector<std::string> methods{"velocity_verlet", "central_difference", "euler_cromer", "rk4",
                                         "odeint_dopri5"};
  std::vector<std::unique_ptr<Dynamics>> dynamics;
  std::vector<bench::Task> tasks;
  const auto add = [&](const std::string& name, const Scene& scene, const Dynamics& compiled, const std::string& method,
                       double step, bool ledger) {
    tasks.push_back({name, [&scene, &compiled, method, step, ledger] {
                       benchmark::DoNotOptimize(
                           advanced(scene, compiled, make_integrator(method), step, steps, ledger));
                     }});
  };
  for (const Named& named : scenes) {
    dynamics.push_back(std::make_unique<Dynamics>(named.scene.model));
    for (const std::string& method : methods)
      add(named.name + "/" + method, named.scene, *dynamics.back(), method, named.step, false);
    add(named.name + "/ledger", named.scene, *dynamics.back(), "velocity_verlet", named.step, true);
  }
  const std::vector<bench::Timing> timings = bench::time_tasks(tasks, repetitions);
  fmt::print("Microseconds a step, ledger off, no output (median of {} interleaved repetitions of {} steps)\n",
             repetitions, steps);
  fmt::print("ratio: to velocity_verlet of the same scene in this run; ledger: velocity_verlet with the ledger on\n\n");
  fmt::print("{:28}", "scene");
  for (const std::string& method : methods)
    fmt::print("{:>22}", method);
  fmt::print("{:>22}\n", "ledger");
  const std::size_t columns = methods.size() + 1;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    fmt::print("{:28}", scenes[s].name);
    for (std::size_t m = 0; m < columns; ++m) {
      const double median = timings[s * columns + m].median;
      fmt::print("{:>12.3f} ({:5.2f}x)  ", median / steps * 1e6, median / timings[s * columns].median);
    }
    fmt::print("\n");
  }
}

/// One run of a work-precision table.
struct Point {
  std::string method;
  double tolerance{};
  long steps{};
};

/// Prints error against evaluations and time for one smooth scene; `error` measures an end state.
template <class Error>
void print_work_precision(const std::string& title, const Scene& scene, double duration, Error&& error) {
  std::vector<Point> points;
  for (const char* method :
       {"central_difference", "velocity_verlet", "rk4", "odeint_dopri5", "odeint_fehlberg78", "odeint_abm8"}) {
    for (long steps = 100; steps <= 12800; steps *= 4)
      points.push_back({method, 0.0, steps});
  }
  for (const double tolerance : {1e-4, 1e-7, 1e-10, 1e-13}) {
    points.push_back({"odeint_dopri5", tolerance, 1});
    points.push_back({"odeint_bulirsch_stoer", tolerance, 1});
  }
  const Dynamics dynamics{scene.model};
  std::vector<Run> runs;
  std::vector<bench::Task> tasks;
  for (const Point& point : points) {
    const auto run = [&scene, &dynamics, &point, duration] {
      return advanced(scene, dynamics, make_integrator(point.method, point.tolerance),
                      duration / static_cast<double>(point.steps), point.steps, false);
    };
    runs.push_back(run());
    tasks.push_back({fmt::format("{}/{}/{}", point.method, point.tolerance, point.steps),
                     [run] { benchmark::DoNotOptimize(run()); }});
  }
  const std::vector<bench::Timing> timings = bench::time_tasks(tasks, repetitions);
  fmt::print("\n{}\n{:24} {:>10} {:>8} {:>10} {:>12} {:>12} {:>26} {:>14}\n", title, "method", "tolerance", "steps",
             "error", "evaluations", "median [us]", "least .. largest [us]", "ns/evaluation");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double evaluations = static_cast<double>(runs[i].evaluations);
    fmt::print("{:24} {:>10} {:>8} {:>10.2e} {:>12} {:>12.1f} {:>12.1f} .. {:>10.1f} {:>14.0f}\n", points[i].method,
               points[i].tolerance == 0.0 ? "fixed" : fmt::format("{:.0e}", points[i].tolerance), points[i].steps,
               error(runs[i].end), runs[i].evaluations, timings[i].median * 1e6, timings[i].smallest * 1e6,
               timings[i].largest * 1e6, timings[i].median * 1e9 / evaluations);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count > 1 && std::string_view{arguments[1]} != "user-runs") {
    fmt::print(stderr, "talus_bench: found \"{}\"; it must be user-runs, for the costs of users' runs alone\n",
               arguments[1]);
    return 2;
  }
  bench::print_user_run_costs();
  if (count > 1) return 0;
  print_step_costs();
  bench::print_fence_costs();
  bench::print_search_costs();
  bench::print_structure_savings();
  bench::print_event_costs();
  bench::print_reading_costs();

  // Not 90 degrees: there the second-order error of the leapfrog vanishes by a coincidence of the elliptic integrals.
  const scenes::Pendulum parameters{.amplitude = 2.0};
  const double frequency = scenes::small_swing_frequency(parameters);
  const auto swing = verification::reference::PendulumMotion::from_rest(frequency, parameters.amplitude);
  const double swing_time = 3.3 * swing.period();
  const auto swung = swing.at(swing_time);
  print_work_precision("Work and precision: rigid pendulum from rest at 2 rad, 3.3 periods; error of the angle [rad]",
                       scenes::pendulum(parameters), swing_time,
                       [&](const State& end) { return std::abs(end.q[0] - swung.angle); });

  Scene launched = scenes::two_cable({.contact = {1e4, 0.0, EndRule::clamped}});
  launched.initial.v = {2.0, 0.0, 0.0, 0.0};
  launched.initial.q[2] = -1000.0;
  const verification::reference::TwoCableMotion motion{{}, 2.0};
  const auto flown = motion.at(20.0);
  print_work_precision(
      "Work and precision: particle on two cables, launched at 2 m/s, at 20 s; error of the position [m]", launched,
      20.0, [&](const State& end) { return std::abs(end.q[0] - flown.position); });
}
