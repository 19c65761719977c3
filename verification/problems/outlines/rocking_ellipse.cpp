#include "verification/reference/outlines/rocking_ellipse.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::rocking_ellipse {
namespace {

constexpr double axis_a = 1.0, axis_b = 0.6, gravity = 9.81, shear_ratio = 1.0 / 3.0;
constexpr reference::RockingEllipse ellipse{axis_a, axis_b, gravity};

/// Scene at rest at the amplitude; contact and friction spring are loaded as during the oscillation.
Scene rocking_scene(double amplitude, double stiffness, const Setup& setup) {
  SceneBuilder builder{si};
  builder.gravity({0.0, -gravity});
  const double inertia = 0.25 * (axis_a * axis_a + axis_b * axis_b);
  const BodyId body = builder.add(
      Body{.name = "ellipse",
           .mass = 1.0,
           .inertia = setup.has("inertia_of_a_ring") ? 2.0 * inertia : inertia,
           .shape = Superquadric{setup.has("longer_axis") ? 1.01 * axis_a : axis_a, axis_b, 2.0},
           .p_WB = {centre_displacement(ellipse, amplitude), centre_height(ellipse, amplitude) - gravity / stiffness},
           .angle = amplitude});
  const BodyId plane = builder.add_fixed("plane", HalfPlane{});
  builder.add_contact("touch", body, plane, LinearSpringDashpot{stiffness, 0.0, EndRule::clamped},
                      CoulombFriction{setup.has("smooth_plane") ? 0.0 : 1e3, shear_ratio * stiffness});
  Scene scene = builder.at_rest("Rocking ellipse");
  const double frequency = small_rocking_frequency(ellipse);
  // The friction force that turns the rolling body stretches the spring.
  scene.initial.z[0] = axis_b * frequency * frequency * amplitude / (shear_ratio * stiffness);
  return scene;
}

double solver_period(double amplitude, double stiffness, double step, const Setup& setup) {
  return period_of(rocking_scene(amplitude, stiffness, setup), VelocityVerlet{}, step, 8.0);
}

double shift(double stiffness) { return frequency_shift(ellipse, 1.0, stiffness, shear_ratio * stiffness); }

void check_amplitudes(Findings& findings, const Setup& setup) {
  const double stiffness = 1e5, step = 2.0071e-4;
  const double rest = 2.0 * std::numbers::pi / small_rocking_frequency(ellipse);
  Series solver{"solver", {}, {}, Style::points}, exact{"rigid", {}, {}, Style::lines};
  for (const double amplitude : {0.02, 0.1, 0.3, 0.6}) {
    if (setup.coarse && amplitude > 0.02) continue;
    const double period = solver_period(amplitude, stiffness, step, setup);
    const double rigid = reference::rocking_period(ellipse, amplitude);
    findings.expect_model(
        {"periods", fmt::format("period at {:g} rad over that of the rigid body", amplitude)}, period / rigid, 1.0,
        1.5 * std::abs(shift(stiffness)),
        "contact springs: their frequency shift for small oscillations, and half of it for the larger angles");
    solver.add(amplitude, period / rest);
  }
  if (setup.coarse) return;
  for (int i = 1; i <= 70; ++i)
    exact.add(0.01 * i, reference::rocking_period(ellipse, 0.01 * i) / rest);
  findings.figure({.name = "amplitude",
                   .title = "Period against amplitude",
                   .caption = "Relative to the period of small oscillations: solver (points) and rigid body (line).",
                   .x = {.label = "amplitude", .unit = "rad"},
                   .y = {.label = "period over that of small oscillations"},
                   .series = {exact, solver}});
}

void check_springs(Findings& findings, const Setup& setup) {
  const double amplitude = 0.02;
  const double rigid = reference::rocking_period(ellipse, amplitude);
  Convergence shifts;
  double ratio = 0.0;
  Series solver{"solver", {}, {}, Style::points}, line{"predicted", {}, {}, Style::lines};
  for (const double stiffness : doublings(1e4, 4)) {
    const double step = 0.05 / std::sqrt(stiffness);
    const double found = rigid / solver_period(amplitude, stiffness, step, setup) - 1.0;
    ratio = found / shift(stiffness);
    shifts.add(1.0 / stiffness, std::abs(found));
    solver.add(1.0 / stiffness, std::abs(found));
    line.add(1.0 / stiffness, std::abs(shift(stiffness)));
  }
  findings.expect_between({"frequency_shift", "frequency shift by the contact springs over its prediction"}, ratio,
                          0.98, 1.02,
                          "first order in the compliances; neglected: the squares of the shift and of the amplitude, "
                          "and the residual oscillation of the springs");
  findings.expect_order("order of the frequency shift in the compliance", shifts, 0.97, 1.03, "first order in 1/k");
  findings.figure({.name = "springs",
                   .title = "Frequency shift by the contact springs",
                   .caption = "Change of the frequency against the compliance $1/k_n$, $k_s = k_n/3$.",
                   .x = {.label = "compliance", .unit = "m/N", .log = true},
                   .y = {.label = "change of the frequency", .log = true},
                   .series = {line, solver}});
}

void check_steps(Findings& findings, const Setup& setup) {
  const double amplitude = 0.02, stiffness = 1e4;
  const double finest = solver_period(amplitude, stiffness, 2.03e-4, setup);
  const double frequency = small_rocking_frequency(ellipse);
  Convergence errors;
  double ratio = 0.0;
  for (const double step : {8.13e-3, 4.07e-3, 2.03e-3}) {
    const double error = solver_period(amplitude, stiffness, step, setup) / finest - 1.0;
    errors.add(step, std::abs(error));
    ratio = error / (-frequency * frequency * step * step / 24.0);
  }
  findings.expect_order({"order_in_step", "order of the period in the step"}, errors, 1.9, 2.15, "leapfrog");
  findings.expect_between(
      {"error_of_step", "error of the period due to the step over (w h)^2/24"}, ratio, 0.85, 1.15,
      "the leapfrog error of a body whose springs follow it instantly; neglected: the springs' dynamics, the fourth "
      "order, and the error of the finest step, which is used as the exact value (a hundredth)");
}

void run(Findings& findings, const Setup& setup) {
  check_amplitudes(findings, setup);
  if (setup.coarse) return;
  check_springs(findings, setup);
  check_steps(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "rocking_ellipse",
      .title = "Rocking ellipse on a plane",
      .requirements = {{"E3",
                        {"periods", "frequency_shift", "order of the frequency shift in the compliance",
                         "order_in_step", "error_of_step"}},
                       {"shape.superquadric", {"periods"}},
                       {"Eq. 18", {"periods", "frequency_shift"}},
                       {"method.resultant", {"periods"}},
                       {"integrator.velocity_verlet", {"order_in_step"}},
                       {"pair.superquadric.half_plane", {"periods"}}},
      .main_checks = {"period at 0.02 rad over that of the rigid body", "period at 0.6 rad over that of the rigid body",
                      "frequency_shift", "error_of_step"},
      .source = "textbook mechanics, derived here",
      .faults = {{"inertia_of_a_ring", "twice the moment of inertia", "period at 0.02 rad over that of the rigid body"},
                 {"smooth_plane", "no friction", "period at 0.02 rad over that of the rigid body"},
                 {"longer_axis", "a horizontal axis 1 % too long", "period at 0.02 rad over that of the rigid body"}},
      .run = run};
}

}  // namespace talus::verification::problems::rocking_ellipse
