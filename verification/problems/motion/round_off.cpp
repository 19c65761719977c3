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
  const RunEnd run = run_steps(scene, integrator_of(method), step, steps, findings);
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
          .faults = {{"far_from_the_origin", "the scene 4096 lengths from the origin of its coordinates",
                      "the scene's rounding over its prediction, velocity_verlet"},
                     {"stiffness_off", "a stiffness 1e-12 too large", "the scene's rounding over its prediction, rk4"},
                     {"forces_in_double", "accelerations that pass through a double on their way to 113 bits",
                      "distance from the method's map in 113 bits, dashpot, rk4"},
                     {"forces_in_float", "accelerations that pass through a float on their way to a double",
                      "log2 of the rounding over its prediction, furthest of all methods and numbers"},
                     {"dashpot_left_on", "a dashpot of 2^-10, which no step makes smaller",
                      "error against the step, truncation, rk4, 24 bits"}},
          .time_limit = 120.0,
          .run = run};
}

}  // namespace talus::verification::problems
