#include <cmath>
#include <vector>

#include "solver/model/model_builder.hpp"
#include "verification/check/case.hpp"
#include "verification/study/findings/curves.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/runs/scene_run.hpp"

namespace talus::verification::problems::beats {
namespace {

constexpr double mass = 2.0, stiffness = 32.0, elongation = 0.25, amplitude = 0.125;  // taut throughout
constexpr double step = 0.015625, end = 64.0;

/// Two particles in a row of three equal taut cables between two walls, the first displaced by the amplitude.
Scene row(const Setup& setup) {
  ModelBuilder builder;
  const BodyId first = builder.add(Body{.name = "first", .mobility = Mobility::sliding_x, .mass = mass});
  const BodyId second = builder.add(Body{.name = "second",
                                         .mobility = Mobility::sliding_x,
                                         .mass = (setup.has("second_particle_lighter") ? 1.0 - 1e-9 : 1.0) * mass,
                                         .p_WB = {1.0, 0.0}});
  const auto add = [&](const char* name, CableEnd from, CableEnd to, double k) {
    builder.add(Cable{.name = name, .a = from, .b = to, .rest_length = 1.0 - elongation, .law = TensionOnly{k}});
  };
  add("left", {std::nullopt, {-1.0, 0.0, 0.0}}, {first, {}}, stiffness);
  add("middle", {first, {}}, {second, {}}, (setup.has("middle_cable_softer") ? 1.0 - 1e-9 : 1.0) * stiffness);
  add("right", {second, {}}, {std::nullopt, {2.0, 0.0, 0.0}}, stiffness);
  Scene scene{.title = "Two particles in a row of cables", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  scene.initial.q[0] += amplitude;
  return scene;
}

/// Displacements of both particles after n steps: modes of angular frequency w that velocity Verlet advances by the
/// phase angle Omega h per step, with sin(Omega h/2) = w h/2.
struct Displacements {
  double first{}, second{};
};
Displacements exact(long n) {
  const auto mode = [n](double w) { return std::cos(2.0 * std::asin(0.5 * w * step) * static_cast<double>(n)); };
  const double together = mode(std::sqrt(stiffness / mass)), against = mode(std::sqrt(3.0 * stiffness / mass));
  return {0.5 * amplitude * (together + against), 0.5 * amplitude * (together - against)};
}

void run(Findings& findings, const Setup& setup) {
  const Scene scene = row(setup);
  const Integrator method = make_integrator(setup.has("rk4") ? "rk4" : "velocity_verlet");
  const long steps = std::lround(end / step);
  double displacement_error = 0.0, tension_error = 0.0;
  Series first{.label = "first", .style = Style::lines}, second{.label = "second", .style = Style::lines};
  Probe probe{scene.model};
  long n = 0;
  run_steps(scene, method, step, steps, findings, [&](const State& state, const StepInfo&) {
    const Displacements want = exact(n);
    const double x1 = state.q[0], x2 = state.q[1] - 1.0;
    keep_worst(displacement_error, x1 - want.first), keep_worst(displacement_error, x2 - want.second);
    probe.evaluate(state);
    keep_worst(tension_error, probe.forces().tensions[1] - stiffness * (elongation + want.second - want.first));
    if (state.t <= 8.0) first.add(state.t, x1), second.add(state.t, x2);
    ++n;
  });
  if (n != steps + 1) displacement_error = tension_error = std::nan("");
  findings.expect("displacements of both particles, largest error", displacement_error, 0.0,
                  Tolerance::round_off(2.1e-14,
                                       "positions up to 1 are rounded by up to 1.1e-16 in each of 4096 steps, which "
                                       "excites both modes: independent roundings add up to 64 x 1.1e-16 = 7e-15; "
                                       "three times that is allowed"),
                  "L");
  findings.expect("tension of the middle cable, largest error", tension_error, 0.0,
                  Tolerance::round_off(2.0 * stiffness * 2.1e-14, "k times the bound of both displacements"), "F");
  if (setup.coarse) return;
  findings.figure({.name = "beats",
                   .title = "Displacements of two coupled particles",
                   .caption = "The first particle is released at 0.125; the motion passes to the second and back.",
                   .x = {.label = "time"},
                   .y = {.label = "displacement"},
                   .series = {first, second}});
}

}  // namespace

Case definition() {
  const std::string displacements = "displacements of both particles, largest error";
  const std::string tension = "tension of the middle cable, largest error";
  return {
      .id = "beats",
      .title = "Beats of two particles in a row of cables",
      .family = "D: cables",
      .requirements = {{"law.tension_only", {displacements, tension}}, {"integrator.velocity_verlet", {displacements}}},
      .main_checks = {displacements, tension},
      .source = "Textbook mechanics",
      .faults = {{"second_particle_lighter", "the second particle is lighter by 1e-9", displacements},
                 {"middle_cable_softer", "the middle cable is softer by 1e-9", tension},
                 {"rk4", "RK4 instead of velocity Verlet", displacements}},
      .run = run};
}

}  // namespace talus::verification::problems::beats
