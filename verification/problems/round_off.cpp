#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/model/model_builder.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/scene_run.hpp"
#include "verification/reference/rounded_swing.hpp"

namespace talus::verification::problems {

Case round_off();

namespace {

using reference::Scalar;
using reference::SwingMethod;

constexpr const char* page = R"(
**Problem.** A mass swings on a cable that stays taut. How much of the error is rounding, how does it grow, and below
which step does a smaller one make the result worse? The same methods in numbers of 53, 64 and 113 bits tell what
rounding a method has in itself.

```
   |~~~~~~~~~~~~~[m]---> F        x'' = -(x - 1.5),  swing of .25
   0     1     1.5
```

**Equations.** Without rounding, velocity Verlet gives $x_n = \cos(n\theta)$, $\sin\frac\theta2 = \frac h2$, and
Runge-Kutta the real part of $(1 - \frac{h^2}2 + \frac{h^4}{24} + i(h - \frac{h^3}6))^n$: both known at 50 digits,
so what a run differs by is rounding and nothing else. Each step rounds $x$ by up to $u = 2^{-53}$ of it, without
direction, so that after $n$ steps about $\sqrt n\,u$ is left. In the scene $x$ stands at 1.5 and swings by .25: six
times as much of the swing. The method's own error is $\frac{t h^2}{24}$ or $\frac{t h^4}{120}$ of the swing; with
rounding $\rho\sqrt{t/h}$ the sum of the two is least where the method's error is $\frac18$ of rounding
(Runge-Kutta), $\frac14$ (Verlet).

**Source.** Henrici 1962, chapter 1 (rounding of steps as a random walk); Hairer, Lubich & Wanner 2006, section
VIII.5.

| symbol | meaning | value |
|:--|:-----------|:--|
| $k$, $m$ | cable, mass | 1, 1 |
| $t$ | time of a run | 10 to 10.2, sixteen runs |
| $u$ | half a unit of the last place | $2^{-53}, 2^{-64}, 2^{-113}$ |

**What would break it.** A coordinate summed in another order than it is used; a sum of times; a scene far from the
origin of its coordinates (six digits are lost a million lengths away); accumulation that always rounds the same way.
)";

constexpr int runs = 16;
constexpr double middle = 1.5, swing = 0.25;

double run_time(int i) { return 10.0 * (1.0 + 0.02 * i / runs); }

Scene swing_scene(const Setup& setup) {
  const double origin = setup.has("far_from_the_origin") ? 4096.0 : 0.0;
  ModelBuilder builder{si};
  const BodyId mass = builder.add(Body{.name = "mass",
                                       .mobility = Mobility::sliding_x,
                                       .mass = 1.0,
                                       .p_WB = {origin + middle + swing, 0.0},
                                       .force = {middle - 1.0, 0.0}});
  builder.add(Cable{.name = "cable",
                    .a = {mass, {}},
                    .b = {std::nullopt, {origin, 0.0, 0.0}},
                    .rest_length = 1.0,
                    .law = TensionOnly{setup.has("stiffness_off") ? 1.0 + 1e-12 : 1.0, 0.0}});
  Scene scene{.title = "Mass on a taut cable", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  return scene;
}

Integrator integrator_of(SwingMethod method) {
  return method == SwingMethod::verlet ? Integrator{VelocityVerlet{}} : Integrator{RungeKutta4{}};
}

/// The solver's place, in swings from the middle.
double solver_place(SwingMethod method, double step, long steps, const Setup& setup, Findings& findings) {
  const Scene scene = swing_scene(setup);
  const RunEnd run = run_steps(scene, integrator_of(method), step, steps);
  findings.count(static_cast<std::uint64_t>(run.evaluations));
  return (run.state.q[0] - (scene.initial.q[0] - swing)) / swing;
}

/// Root mean square over the runs of what rounding leaves after `steps` steps.
double solver_rounding(SwingMethod method, long steps, const Setup& setup, Findings& findings) {
  double sum = 0.0;
  for (int i = 0; i < runs; ++i) {
    const double step = run_time(i) / static_cast<double>(steps);
    const double error =
        solver_place(method, step, steps, setup, findings) - reference::unrounded_place(method, step, steps);
    sum += error * error;
  }
  return std::sqrt(sum / runs);
}

double own_rounding(SwingMethod method, Scalar scalar, long steps) {
  double sum = 0.0;
  for (int i = 0; i < runs; ++i) {
    const double error = reference::rounding_error(method, scalar, run_time(i) / static_cast<double>(steps), steps);
    sum += error * error;
  }
  return std::sqrt(sum / runs);
}

const char* name_of(SwingMethod method) { return method == SwingMethod::verlet ? "velocity_verlet" : "rk4"; }

/// The numbers that a method is stepped in, and the solver.
void check_scalars(Findings& findings, const Setup& setup, SwingMethod method, Table& table) {
  const long steps = 2000;
  const double in_double = own_rounding(method, Scalar::bits_53, steps);
  const double expected = std::sqrt(static_cast<double>(steps)) * 0x1p-53;
  const double by_solver = solver_rounding(method, steps, setup, findings);
  findings.expect_between(fmt::format("log2 of the solver's rounding over sqrt(n) u x/swing, {}", name_of(method)),
                          std::log2(by_solver / (expected * (middle + swing) / swing)),
                          method == SwingMethod::verlet ? -3.5 : -1.3, method == SwingMethod::verlet ? -0.5 : 0.7,
                          "each addition to x rounds by u/sqrt(3), of which the swing keeps sqrt(1/2): 2^-1.3 for "
                          "one in a step, 2^-.3 for the four of Runge-Kutta; u is of the power of two above x, "
                          "and sixteen runs of one swing are not independent");
  if (setup.coarse) return;
  for (const Scalar scalar : {Scalar::bits_64, Scalar::bits_113}) {
    const double finer = own_rounding(method, scalar, steps);
    const double bits = std::log2(reference::unit_round_off(scalar) * 0x1p53);
    findings.expect_between(
        fmt::format("log2 of the rounding in {} bits over that in 53, {}", scalar == Scalar::bits_64 ? 64 : 113,
                    name_of(method)),
        std::log2(finer / in_double), bits - 0.5, bits + 0.5,
        "the ratio of the last places; sixteen runs each tell a root mean square to a fifth, and how constants round "
        "differs");
    table.rows.push_back({name_of(method), scalar == Scalar::bits_64 ? "64" : "113", fmt::format("{:.1e}", finer)});
  }
  table.rows.push_back({name_of(method), "53", fmt::format("{:.1e}", in_double)});
  table.rows.push_back({name_of(method), "53, solver", fmt::format("{:.1e}", by_solver)});
}

/// The solver's whole error against the step, and where it is least.
void check_best_step(Findings& findings, const Setup& setup, SwingMethod method, long most, Figure& figure) {
  Series whole{fmt::format("{}, whole error", name_of(method)), {}, {}, Style::linespoints};
  Series rounding{fmt::format("{}, rounding", name_of(method)), {}, {}, Style::points};
  Series own{fmt::format("{}, method", name_of(method)), {}, {}, Style::lines};
  Convergence growth;
  double least = 1.0, best = 0.0, rho = 0.0;
  for (long steps = most / 256; steps <= most; steps *= 2) {
    double sum = 0.0, sum_own = 0.0;
    const int count = steps > 1000000 ? 2 : steps > 10000 ? 4 : runs;
    double left = 0.0;
    for (int i = 0; i < count; ++i) {
      const double step = run_time(i * runs / count) / static_cast<double>(steps);
      const double place = solver_place(method, step, steps, setup, findings);
      const double left_now = place - reference::unrounded_place(method, step, steps);
      const double own_now = reference::method_error(method, step, steps);
      left += left_now * left_now / count;
      sum_own += own_now * own_now / count;
      sum += (left_now + own_now) * (left_now + own_now) / count;
    }
    const double step = 10.1 / static_cast<double>(steps);
    for (Series* series : {&whole, &rounding, &own})
      series->x.push_back(step);
    whole.y.push_back(std::sqrt(sum));
    rounding.y.push_back(std::sqrt(left));
    own.y.push_back(std::sqrt(sum_own));
    growth.add(static_cast<double>(steps), std::sqrt(left));
    if (std::sqrt(sum) < least) least = std::sqrt(sum), best = step;
    rho = std::sqrt(left / (10.1 / step));
  }
  findings.expect_order(fmt::format("rounding against the number of steps, {}", name_of(method)), growth, 0.3, 0.7,
                        "a random walk grows with the square root; a tenth of steps that round alike adds to it");
  // The method's error of t h^p/c is 1/(2 p) of rounding: h^(p + 1/2) = rho c sqrt(t)/(2 p t s), s the mean of |sin t|.
  const double sine = 0.60, order = method == SwingMethod::verlet ? 2.0 : 4.0;
  const double constant = method == SwingMethod::verlet ? 24.0 : 120.0;
  const double predicted =
      std::pow(rho * constant * std::sqrt(10.1) / (2.0 * order * 10.1 * sine), 1.0 / (order + 0.5));
  findings.expect_between(fmt::format("log2 of the step of least error over its prediction, {}", name_of(method)),
                          std::log2(best / predicted), -1.0, 1.0,
                          "steps are tried at factors of two, and the sum of both errors is flat about its least");
  findings.note(
      fmt::format("{}: least error {:.1e} of the swing at h = {:.1e} s, predicted {:.1e}; below, the "
                  "error rises.",
                  name_of(method), least, best, predicted));
  figure.series.push_back(whole);
  figure.series.push_back(rounding);
  figure.series.push_back(own);
}

void run(Findings& findings, const Setup& setup) {
  Table table{.name = "scalars",
              .caption = "Rounding after 2000 steps, over the swing: root mean square of sixteen runs.",
              .columns = {"method", "bits", "rounding"},
              .rows = {}};
  check_scalars(findings, setup, SwingMethod::verlet, table);
  check_scalars(findings, setup, SwingMethod::runge_kutta, table);
  if (setup.coarse) return;
  findings.table(table);
  Figure figure{.name = "least",
                .title = "The step of least error",
                .caption =
                    "Error of the place after about ten time units, over the swing: the whole, and its part from "
                    "rounding.",
                .x = {.label = "step", .unit = "s", .log = true},
                .y = {.label = "error over the swing", .log = true},
                .series = {}};
  check_best_step(findings, setup, SwingMethod::runge_kutta, 100000, figure);
  if (setup.tier == Tier::full) check_best_step(findings, setup, SwingMethod::verlet, 16384000, figure);
  findings.figure(figure);
}

}  // namespace

Case round_off() {
  return {.id = "round_off",
          .title = "What rounding leaves",
          .requirements = {{"A8", {"rounding", "least error"}},
                           {"law.tension_only", {"solver's rounding"}},
                           {"integrator.velocity_verlet", {"velocity_verlet"}},
                           {"integrator.rk4", {"rk4"}}},
          .main_checks = {"log2 of the solver's rounding over sqrt(n) u x/swing, velocity_verlet",
                          "log2 of the rounding in 64 bits over that in 53, velocity_verlet",
                          "log2 of the step of least error over its prediction, rk4"},
          .source = "Henrici 1962, chapter 1; Hairer, Lubich & Wanner 2006, section VIII.5",
          .page = page,
          .faults = {{"far_from_the_origin", "the scene 4096 lengths from the origin of its coordinates",
                      "log2 of the solver's rounding over sqrt(n) u x/swing, velocity_verlet"},
                     {"stiffness_off", "a stiffness 1e-12 too large",
                      "log2 of the solver's rounding over sqrt(n) u x/swing, rk4"}},
          .tier = Tier::quick,
          .time_limit = 120.0,
          .run = run};
}

}  // namespace talus::verification::problems
