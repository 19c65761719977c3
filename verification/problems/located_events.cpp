#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "solver/model/model_builder.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "solver/scenes/pendulum.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/fence_table.hpp"
#include "verification/reference/damped_bounce.hpp"
#include "verification/reference/pendulum.hpp"
#include "verification/reference/two_cable.hpp"

namespace talus::verification::problems {

Case located_events();

namespace {

constexpr const char* page = R"(
**Problem.** How many force evaluations does a result of a given accuracy cost? Four motions with exact solutions and
the fence of Table 2, by `stormer_cowell`: steps of variable order and length, cut where a mode ends.

**Method.** Through the accelerations at the last $k \le 12$ times goes a polynomial,
$\ddot q(t) = \sum_i d_i N_i(t)$, $N_i = (t-t_0)\cdots(t-t_{i-1})$ (Newton's divided differences $d_i$). Integrated once
and twice it predicts velocity and place; one force evaluation there, $d_k = (\ddot q_{new} - \sum_{i<k} d_i
N_i)/N_k$, adds one term. That term is the error estimate. Order and step are those that allow the longest next step
with the estimate below the tolerance, as a share of the longest way and the largest speed of the run so far. The same
polynomial is known between the steps: outputs cost nothing, and where a guard falls to nought inside a step its root is
bracketed and found to round-off (Alefeld et al. 1995); there the modes change and the motion begins anew with order 1.

**Hypothesis**, written before the data: on smooth pieces errors fall with the power 12 of the step, so that each digit
costs a tenth more evaluations; classical methods pay a factor of 3 (order 2) or 10 (order 1, which events force upon
them).

| scene | exact by |
|:---|:------|
| pendulum $\ddot x = -9.81 \sin x$ from rest at 90 degrees, 24.388772 s | elliptic functions |
| the same from 170 degrees, 50.4033 s | elliptic functions |
| particle on two cables, $k = 4$, $l = 10$, $m = 1$, $v = 2$, 50 s | inverted quadrature |
| damped bounce, $\omega_0 = 100$, $\xi = .2$, clamped, gap .618, $v = 1$, 3 s | closed form, piece by piece |
| fence, Table 2, 600 lb, slack .5, to .05 s and .2 s | the same method at $10^{-13}$, and 1993's at small steps |

Error: the largest over 20 equally spaced times of place and velocity, each over its largest. "Evaluations to reach": of
the cheapest run from which on all finer ones are as good.

**Source.** Stoermer 1907; Cowell & Crommelin 1910; Krogh 1974; Shampine & Gordon 1975; Alefeld et al. 1995.

**What would break it.** An event located by one step too late; a polynomial that goes on through an event; an error
estimate of the wrong power; a step that outgrows what its order bears.
)";

/// A coordinate and its velocity at a time.
struct Truth {
  double place{};
  double velocity{};
};

struct Motion {
  const char* name;
  Scene scene;
  double duration{};
  std::size_t coordinate{};
  std::function<Truth(double)> exact;
  double asked[2];       ///< evaluations at most for errors of 1e-6 and 1e-9
  const char* admitted;  ///< and why so many
  double known[2];       ///< the best that odeint's steppers take
};

constexpr int outputs = 20;
constexpr const char* fewer = "less than the best of odeint's steppers takes";

Scene two_cables() {
  ModelBuilder builder{si};
  const BodyId particle = builder.add(Body{.name = "particle", .mobility = Mobility::particle, .mass = 1.0});
  for (const double side : {10.0, -10.0}) {
    builder.add(Cable{.name = side > 0.0 ? "upper" : "lower",
                      .a = {particle, {}},
                      .b = {std::nullopt, {0.0, side, 0.0}},
                      .rest_length = 10.0,
                      .law = TensionOnly{4.0, 0.0}});
  }
  Scene scene{.title = "Particle on two cables", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, particle, {2.0, 0.0}, 0.0);
  return scene;
}

Motion swing(const char* name, double amplitude, double duration, std::array<double, 2> asked,
             std::array<double, 2> known) {
  // Nearly all mass at the end of the arm: w0^2 = g to the last digit.
  const auto motion = reference::PendulumMotion::from_rest(std::sqrt(9.81), amplitude);
  return {name,
          scenes::pendulum({.mass = 1.0, .inertia = 1e-20, .arm = 1.0, .gravity = 9.81, .amplitude = amplitude}),
          duration,
          0,
          [motion](double t) {
            const auto state = motion.at(t);
            return Truth{state.angle, state.rate};
          },
          {asked[0], asked[1]},
          fewer,
          {known[0], known[1]}};
}

std::vector<Motion> motions() {
  constexpr double degree = std::numbers::pi / 180.0;
  std::vector<Motion> all;
  all.push_back(swing("pendulum, 90 degrees", 90.0 * degree, 24.388772, {1200.0, 3000.0}, {1694.0, 5460.0}));
  all.push_back(swing("pendulum, 170 degrees", 170.0 * degree, 50.4033, {5000.0, 10000.0}, {6814.0, 14814.0}));
  const reference::TwoCableMotion on_cables{{.stiffness = 4.0, .length = 10.0, .mass = 1.0}, 2.0};
  all.push_back({"two cables",
                 two_cables(),
                 50.0,
                 0,
                 [on_cables](double t) {
                   const auto state = on_cables.at(t);
                   return Truth{state.position, state.velocity};
                 },
                 {900.0, 1800.0},
                 fewer,
                 {1134.0, 2854.0}});
  const double w = 100.0, xi = 0.2;
  const reference::DampedBounce drop{w, xi, 9.81, 0.618, 1.0, reference::EndRule::clamped};
  std::vector<double> times;
  for (int i = 0; i <= outputs; ++i)
    times.push_back(3.0 * i / outputs);
  const auto states = reference::bounce_states(drop, times);
  all.push_back({"damped bounce",
                 scenes::bouncing_disc({.mass = 1.0,
                                        .radius = 1.0,
                                        .gap = 0.618,
                                        .speed = 1.0,
                                        .gravity = 9.81,
                                        .contact = LinearSpringDashpot{w * w, 2.0 * xi * w, EndRule::clamped}}),
                 3.0,
                 1,
                 [states](double t) {
                   const auto& state = states[static_cast<std::size_t>(std::lround(t * outputs / 3.0))];
                   return Truth{1.0 + state.gap, -state.velocity};
                 },
                 {4000.0, 4000.0},
                 "a hundredth of what velocity Verlet takes to 1e-6",
                 {153.0, 350.0}});
  return all;
}

/// Error and cost of one run; an error of NaN if it failed.
struct Point {
  double error{};
  double evaluations{};
  long events{};
};

/// The method, or what a fault makes of its use.
Integrator method(const Setup& setup, double tolerance) {
  if (setup.has("no_events")) return make_integrator("odeint_fehlberg78", tolerance);
  return make_integrator("stormer_cowell", tolerance);
}

Point run_motion(const Motion& motion, const Integrator& integrator, Findings& findings) {
  const Dynamics dynamics{motion.scene.model};
  RigidBodySystem system{dynamics, false};
  Integrator running = integrator;
  State state = motion.scene.initial;
  const double interval = motion.duration / outputs;
  double place = 0.0, velocity = 0.0, largest_place = 0.0, largest_velocity = 0.0;
  const Observer observer = [&](const State& seen, const StepInfo& info) {
    if (info.step == 0) return;
    const Truth truth = motion.exact(interval * static_cast<double>(info.step));
    place = std::max(place, std::abs(seen.q[motion.coordinate] - truth.place));
    velocity = std::max(velocity, std::abs(seen.v[motion.coordinate] - truth.velocity));
    largest_place = std::max(largest_place, std::abs(truth.place));
    largest_velocity = std::max(largest_velocity, std::abs(truth.velocity));
  };
  const Outcome outcome =
      simulate(system, running, state, {interval, motion.duration, interval, false}, {&observer, 1});
  findings.count(static_cast<std::uint64_t>(system.evaluations()));
  Point point{std::max(place / largest_place, velocity / largest_velocity), static_cast<double>(system.evaluations())};
  if (!outcome) point.error = std::nan("");
  if (const auto* located = std::get_if<StormerCowell>(&running)) point.events = located->events();
  return point;
}

/// Points in order of falling tolerance: the fewest evaluations from which on all runs are as good; infinite for none.
double evaluations_to_reach(const std::vector<Point>& points, double error) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = points.size(); i-- > 0 && points[i].error <= error;)
    least = points[i].evaluations;
  return least;
}

std::string whole(double number) { return std::isfinite(number) ? fmt::format("{:.0f}", number) : "not reached"; }

void check_motion(const Motion& motion, Findings& findings, const Setup& setup, Table& table, Figure& figure) {
  std::vector<Point> points;
  Series series{.label = motion.name, .x = {}, .y = {}};
  for (double tolerance = 1e-3; tolerance > 1e-12; tolerance /= std::sqrt(10.0)) {
    points.push_back(run_motion(motion, method(setup, tolerance), findings));
    if (points.back().error > 0.0) {
      series.x.push_back(points.back().evaluations);
      series.y.push_back(points.back().error);
    }
  }
  figure.series.push_back(series);
  const double reached[] = {evaluations_to_reach(points, 1e-6), evaluations_to_reach(points, 1e-9)};
  const std::string words = fmt::format(
      "{}: {:.0f} and {:.0f} evaluations are admitted for 1e-6 and 1e-9; fewer than a "
      "fiftieth would say that something was not counted",
      motion.admitted, motion.asked[0], motion.asked[1]);
  findings.expect_between(fmt::format("evaluations to reach 1e-6 over the most that are admitted, {}", motion.name),
                          reached[0] / motion.asked[0], 0.02, 1.0, words);
  findings.expect_between(fmt::format("evaluations to reach 1e-9 over the most that are admitted, {}", motion.name),
                          reached[1] / motion.asked[1], 0.02, 1.0, words);
  table.rows.push_back({motion.name, whole(evaluations_to_reach(points, 1e-4)), whole(reached[0]), whole(reached[1]),
                        whole(motion.known[0]), whole(motion.known[1]), fmt::format("{}", points.back().events)});
}

/// Speed of the rock and largest tension of a fence run to its end.
struct FencePoint {
  double speed{};
  double tension{};
  double evaluations{};
  long events{};
};

FencePoint run_fence_to(const Scene& scene, std::size_t rock, const Integrator& integrator, double step, double end,
                        Findings& findings) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, false};
  Integrator running = integrator;
  State state = scene.initial;
  Workspace work = dynamics.workspace();
  LawForces forces;
  FencePoint point;
  const Observer observer = [&](const State& seen, const StepInfo& info) {
    point.speed = seen.v[rock];
    if (!info.due) return;
    dynamics.update(seen, work);
    dynamics.forces(seen, work, forces);
    point.tension = std::max(point.tension, *std::max_element(forces.tensions.begin(), forces.tensions.end()));
  };
  const Outcome outcome = simulate(system, running, state, {step, end, end / 2500.0, false}, {&observer, 1});
  findings.count(static_cast<std::uint64_t>(system.evaluations()));
  point.evaluations = static_cast<double>(system.evaluations());
  if (!outcome) point.speed = std::nan("");
  if (const auto* located = std::get_if<StormerCowell>(&running)) point.events = located->events();
  return point;
}

void check_fence(Findings& findings, const Setup& setup, Figure& figure) {
  const scenes::FenceScene made = scenes::fence_scene(published_fence("table_2.DAT"));
  const Scene& scene = made.scene;
  const auto rock = static_cast<std::size_t>(
      std::find_if(scene.initial.v.begin(), scene.initial.v.end(), [](double v) { return v != 0.0; }) -
      scene.initial.v.begin());
  Table table{.name = "fence",
              .caption = "The fence of Table 2 by tolerance: error of the largest tension and of the rock's speed.",
              .columns = {"end [s]", "tolerance", "evaluations", "events", "tension", "speed"},
              .rows = {}};
  struct Span {
    double end;
    const char* words;
  };
  for (const Span span : {Span{0.05, ".05 s"}, Span{0.2, ".2 s"}}) {
    const auto at = [&](double tolerance) {
      const char* name = setup.has("fence_without_events") ? "odeint_dopri5" : "stormer_cowell";
      return run_fence_to(scene, rock, make_integrator(name, tolerance), span.end / 2500.0, span.end, findings);
    };
    const FencePoint best = at(1e-13);
    std::vector<Point> tensions, speeds;
    Series series{.label = fmt::format("fence, {}", span.words), .x = {}, .y = {}};
    for (double tolerance = 1e-3; tolerance > 1e-10; tolerance /= 10.0) {
      const FencePoint found = at(tolerance);
      tensions.push_back({std::abs(found.tension / best.tension - 1.0), found.evaluations, found.events});
      speeds.push_back({std::abs(found.speed / best.speed - 1.0), found.evaluations, found.events});
      series.x.push_back(found.evaluations);
      series.y.push_back(speeds.back().error);
      table.rows.push_back({span.words, fmt::format("{:.0e}", tolerance), fmt::format("{}", found.evaluations),
                            fmt::format("{}", found.events), fmt::format("{:.0e}", tensions.back().error),
                            fmt::format("{:.0e}", speeds.back().error)});
    }
    figure.series.push_back(series);
    const auto demand = [&](const char* what, double error_tension, double error_speed, double most) {
      const double found =
          std::max(evaluations_to_reach(tensions, error_tension), evaluations_to_reach(speeds, error_speed));
      findings.expect_between(
          fmt::format("fence, evaluations to reach {} over {:.0f}", what, most), found / most, 0.02, 1.0,
          "what a program written for this one fence took, with located events; fewer than a fiftieth would say that "
          "something was not counted");
    };
    if (span.end < 0.1) {
      demand("1e-5 of tension and 1.4e-4 of speed at .05 s", 1e-5, 1.4e-4, 561.0);
      demand("2e-7 of tension and 3e-6 of speed at .05 s", 2e-7, 3e-6, 1071.0);
      if (setup.coarse) return;
      // Another method that shares only the forces. Events late by up to a step make it first order.
      const auto classical = [&](double step) {
        return run_fence_to(scene, rock, make_integrator("central_difference"), step, span.end, findings).speed;
      };
      const double coarse = classical(4e-7), fine = classical(2e-7);
      findings.expect("fence, speed of the rock at .05 s: central difference, extrapolated", 2.0 * fine - coarse,
                      best.speed,
                      Tolerance::truncation(0.5 * std::abs(fine - coarse), 1.0,
                                            "steps of 4e-7 and 2e-7 s extrapolated by their first order, of whose "
                                            "difference half is left where events fall otherwise in their steps"),
                      "ft/s");
    } else {
      demand("7e-5 of speed at .2 s", 1.0, 7e-5, 2166.0);
    }
  }
  findings.table(table);
}

void run(Findings& findings, const Setup& setup) {
  Table table{.name = "evaluations",
              .caption = "Evaluations to reach an error, those of the best of odeint's steppers, and events located.",
              .columns = {"motion", "1e-4", "1e-6", "1e-9", "odeint 1e-6", "odeint 1e-9", "events"},
              .rows = {}};
  Figure figure{.name = "work_precision",
                .title = "Error against force evaluations, located events",
                .caption =
                    "Each line is one scene with tolerances from 1e-3 to 1e-12. Dashed: order 2, for which ten "
                    "times the evaluations give two digits.",
                .x = {.label = "force evaluations", .unit = "1", .log = true},
                .y = {.label = "error", .unit = "1", .log = true},
                .series = {},
                .slopes = {{-2.0, 2000.0, 1e-3, "order 2"}}};
  for (const Motion& motion : motions())
    check_motion(motion, findings, setup, table, figure);
  check_fence(findings, setup, figure);
  if (setup.coarse) return;
  findings.table(table);
  findings.figure(figure);
}

}  // namespace

Case located_events() {
  return {.id = "located_events",
          .title = "Steps of variable order, cut at events",
          .family = "speed and accuracy",
          .requirements = {{"integrator.stormer_cowell", {"evaluations to reach"}}},
          .main_checks = {"evaluations to reach 1e-6 over the most that are admitted, pendulum, 90 degrees",
                          "evaluations to reach 1e-9 over the most that are admitted, pendulum, 170 degrees",
                          "evaluations to reach 1e-9 over the most that are admitted, two cables",
                          "evaluations to reach 1e-9 over the most that are admitted, damped bounce",
                          "fence, speed of the rock at .05 s: central difference, extrapolated",
                          "fence, evaluations to reach 7e-5 of speed at .2 s over 2166"},
          .source = "Stoermer 1907; Cowell & Crommelin 1910; Krogh 1974; Shampine & Gordon 1975; Alefeld et al. 1995",
          .page = page,
          .faults = {{"no_events", "Fehlberg 7(8) under step control, which does not stop at events",
                      "evaluations to reach 1e-6 over the most that are admitted, damped bounce"},
                     {"fence_without_events", "Dormand-Prince 5 under step control, which does not stop at events",
                      "fence, evaluations to reach 2e-7 of tension and 3e-6 of speed at .05 s over 1071"}},
          .tier = Tier::quick,
          .time_limit = 60.0,
          .run = run};
}

}  // namespace talus::verification::problems
