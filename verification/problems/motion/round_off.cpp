#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "solver/model/model_builder.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/motion/swing_in_numbers_findings.hpp"
#include "verification/reference/stepped_swing.hpp"
#include "verification/study/scene_run.hpp"

namespace talus::verification::problems {

Case round_off();

namespace {

using reference::SwingMethod;

constexpr const char* page = R"(
**Problem.** A body swings on a spring. How much of the error is rounding, how does it grow, and below which step does
a smaller one make the result worse? The solver's integrators of fixed step are templates on the numbers that they step
in; here they step one body in numbers of 24, 53, 64 and 113 bits. Scenes run in 53: a mass on a cable that stays taut.

```
   |~~~~~~~~~~~~~[m]---> F        x'' = -(x - 1.5),  swing of .25        x'' = -x - c x',  x(0) = 1
   0     1     1.5                (a scene)                              (one body, any numbers)
```

**Equations.** On a linear spring with a dashpot each method is one matrix; its powers at 50 digits are the places
without rounding, and what a run differs by is rounding and nothing else. An addition to $x$ or $v$ rounds by a last
place $w$ of the sum, evenly within $\pm\frac w2$: $\frac{w^2}{12}$ in the mean square. With $u = 2^{-b}$ in numbers of
$b$ bits, $w = u$ where $|\cos t| > \frac12$, $\frac u2$ above $\frac14$, and so on: $.716\,u^2$ in the mean. A swing
keeps half of it, so that with $a$ additions a step (2 for the central differences and Euler-Cromer, 8 for Runge-Kutta;
5 for velocity Verlet, whose half kicks before and after the end of a step are equal and round alike: $1 + 2^2$)

$$\rho^2 = \frac{.716\,a\,u^2}{24}\,n$$

is left after $n = t/h$ steps. The methods' own errors are $\frac h2\sin t$ (Euler-Cromer),
$\frac{t h^2}{24}\sin t$ (the leapfrogs) and $\frac{t h^4}{120}\sin t$. The sum $E^2 + \rho^2$, $E \sim h^p$, is least where
$2p\,E^2 = \rho^2$. No constant is fitted. The walk is random while places that follow each other move by more than a
last place more or less, $h^2 > u$; below, roundings are alike and no such law holds (Euler-Cromer in 24 bits, whose
least lies there, is followed for its order alone). In the scene $x$ stands at 1.5, $w = 2u$, and swings by .25.

**Source.** Henrici 1962, chapter 1 (rounding of steps as a random walk); Hairer, Lubich & Wanner 2006, section
VIII.5.

| symbol | meaning | value |
|:--|:-----------|:--|
| $k$, $m$ | spring or cable, mass | 1, 1 |
| $c$ | dashpot, where each method is held to its map in 113 bits | 1/8 |
| $t$ | times of the runs, spread over half a swing | 10 to 13.1 |
| $u$ | half a unit of the last place of 1 | $2^{-24}, 2^{-53}, 2^{-64}, 2^{-113}$ |

**What would break it.** A constant or a sum of fewer bits in an integrator; a dashpot that sees another velocity; a
coordinate summed in another order than it is used; a scene far from the origin of its coordinates (six digits are lost
a million lengths away); accumulation that always rounds the same way.
)";

constexpr int runs = 16;
constexpr double middle = 1.5, swing = 0.25;

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
  return method == SwingMethod::velocity_verlet ? Integrator{VelocityVerlet{}} : Integrator{RungeKutta4{}};
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
    const double step = (10.0 + std::numbers::pi * (i + 0.5) / runs) / static_cast<double>(steps);
    const double error =
        solver_place(method, step, steps, setup, findings) - reference::unrounded_place({method, 0.0, step, steps});
    sum += error * error;
  }
  return std::sqrt(sum / runs);
}

/// The whole solver on a scene.
void check_scene(Findings& findings, const Setup& setup, SwingMethod method) {
  const bool verlet = method == SwingMethod::velocity_verlet;
  const long steps = 2000;
  // One addition to x, or four; those to v are of numbers eight times as small.
  const double predicted = std::sqrt(static_cast<double>(steps) * (verlet ? 1.0 : 4.0) / 6.0) * 0x1p-53 / swing;
  const double left = solver_rounding(method, steps, setup, findings);
  findings.expect_between(
      fmt::format("the scene's rounding over its prediction, {}", verlet ? "velocity_verlet" : "rk4"), left / predicted,
      0.5, 2.0, "sixteen runs tell a root mean square to a fifth; the force rounds, too");
}

void run(Findings& findings, const Setup& setup) {
  check_scene(findings, setup, SwingMethod::velocity_verlet);
  check_scene(findings, setup, SwingMethod::runge_kutta);
  check_numbers(findings, setup);
  check_best_steps(findings, setup);
}

}  // namespace

Case round_off() {
  return {.id = "round_off",
          .title = "What rounding leaves",
          .requirements = {{"A8", {"rounding", "least error", "error against the step", "in 113 bits"}},
                           {"law.tension_only", {"scene's rounding"}},
                           {"integrator.central_difference", {", central_difference"}},
                           {"integrator.lagged_central_difference", {"lagged_central_difference"}},
                           {"integrator.velocity_verlet", {"velocity_verlet"}},
                           {"integrator.euler_cromer", {"euler_cromer"}},
                           {"integrator.rk4", {"rk4"}}},
          .main_checks = {"the scene's rounding over its prediction, velocity_verlet",
                          "log2 of the rounding over its prediction, furthest of all methods and numbers",
                          "log2 of the step of least error over its prediction, furthest of all"},
          .source = "Henrici 1962, chapter 1; Hairer, Lubich & Wanner 2006, section VIII.5",
          .page = page,
          .faults = {{"far_from_the_origin", "the scene 4096 lengths from the origin of its coordinates",
                      "the scene's rounding over its prediction, velocity_verlet"},
                     {"stiffness_off", "a stiffness 1e-12 too large", "the scene's rounding over its prediction, rk4"},
                     {"forces_in_double", "accelerations that pass through a double on their way to 113 bits",
                      "distance from the method's map in 113 bits, dashpot, rk4"},
                     {"forces_in_float", "accelerations that pass through a float on their way to a double",
                      "log2 of the rounding over its prediction, furthest of all methods and numbers"},
                     {"dashpot_left_on", "a dashpot of 2^-10, which no step makes smaller",
                      "error against the step, truncation, rk4, 24 bits"}},
          .tier = Tier::quick,
          .time_limit = 120.0,
          .run = run};
}

}  // namespace talus::verification::problems
