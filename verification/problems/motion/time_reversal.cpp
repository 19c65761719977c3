#include <random>

#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pendulum.hpp"
#include "verification/study/scenes/moved_scene.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::time_reversal {
namespace {

constexpr long reversal_steps = 10000;

struct Reversible {
  const char* name;
  Scene scene;
  double step;
};

Scene bobs_on_cables() {
  SceneBuilder builder{si};
  builder.gravity({0.0, -9.81});
  const auto bob = [&](const char* name, double mass, Vec2 position) {
    return builder.add_particle(name, mass, position);
  };
  const BodyId one = bob("one", 1.1, {1.0, -0.1}), two = bob("two", 0.8, {2.1, 0.05});
  const auto cable = [&](const char* name, CableEnd a, CableEnd b) {
    builder.add_cable(name, a, b, 0.7, TensionOnly{300.0, 0.0});
  };
  cable("left", {std::nullopt, {}}, {one, {}});
  cable("middle", {one, {}}, {two, {}});
  cable("right", {two, {}}, {std::nullopt, {3.0, 0.2, 0.0}});
  Scene scene = builder.at_rest("Bobs on cables");
  set_velocity(scene.model, scene.initial, one, {0.3, 0.5}, 0.0);
  return scene;
}

Scene disc_on_friction_spring() {
  SceneBuilder builder{si};
  builder.gravity({0.4, -9.81});
  const BodyId disc = builder.add_free("disc", 1.0, 0.125, Circle{0.5}, {0.0, 0.5 - 1e-3});
  const BodyId plane = builder.add_fixed("plane", HalfPlane{});
  builder.add_contact("touch", disc, plane, LinearSpringDashpot{1e4, 0.0}, CoulombFriction{50.0, 3e3});
  Scene scene = builder.at_rest("Disc on its friction");
  set_velocity(scene.model, scene.initial, disc, {0.02, 0.004}, -0.05);
  return scene;
}

std::vector<Reversible> reversible_scenes() {
  scenes::BouncingDisc bounce{.gap = 0.3, .gravity = 9.81, .contact = LinearSpringDashpot{1e4, 0.0}};
  return {{"pendulum", scenes::pendulum({.amplitude = 2.2}), 0.004},
          {"bounce", scenes::bouncing_disc(bounce), 0.0007},
          {"cables", bobs_on_cables(), 0.002},
          {"rolling", disc_on_friction_spring(), 0.001}};
}

/// State after `steps` steps from the given one, whose time is set to zero; not finite if the run diverged.
State proceed(const Scene& scene, State state, const Integrator& method, double step, long steps, Findings& findings) {
  Scene from = scene;
  from.initial = std::move(state);
  from.initial.t = 0.0;
  return run_steps(from, method, step, steps, findings).state;
}

State turned(State state) {
  for (double& v : state.v)
    v = -v;
  return state;
}

/// Return error of a scene, the error that rounding explains, and the growth of differences on the way back.
struct Return {
  double missed{}, rounding{}, growth{};
};

Return there_and_back(const Reversible& one, const Integrator& method, double step, long steps, bool explain,
                      Findings& findings) {
  const State start = one.scene.initial;
  const State there = proceed(one.scene, start, method, step, steps, findings);
  const State back = turned(proceed(one.scene, turned(there), method, step, steps, findings));
  const Difference missed = difference(start, back);
  Return found{std::max(missed.position, missed.velocity), 0.0, 1.0};
  if (!explain) return found;
  double largest = 0.0;
  for (const State* state : {&start, &there}) {
    for (std::size_t i = 0; i < state->q.size(); ++i)
      keep_largest(largest, state->q[i]), keep_largest(largest, state->v[i]);
  }
  constexpr double change = 1e-8;
  std::mt19937_64 random{3};
  std::uniform_real_distribution<double> any{-change, change};
  for (int i = 0; i < 2; ++i) {
    State other = turned(there);
    for (std::size_t k = 0; k < other.q.size(); ++k)
      other.q[k] += any(random), other.v[k] += any(random);
    const Difference grown = difference(back, turned(proceed(one.scene, other, method, step, steps, findings)));
    keep_largest(found.growth, grown.position / change), keep_largest(found.growth, grown.velocity / change);
  }
  found.rounding = std::sqrt(2.0 * static_cast<double>(steps)) * 0x1p-53 * largest * found.growth;
  return found;
}

Integrator given(const char* name, const Setup& setup) {
  if (setup.has("runge_kutta_for_verlet")) return RungeKutta4{};
  if (setup.has("euler_for_verlet")) return EulerCromer{};
  return make_integrator(name);
}

Reversible with_fault(Reversible one, const Setup& setup) {
  if (!setup.has("a_little_damping")) return one;
  for (Contact& contact : one.scene.model.contacts)
    std::get<LinearSpringDashpot>(contact.law).damping = 1e-6;
  return one;
}

void check_orders(Findings& findings, const Reversible& pendulum) {
  Figure figure{
      .name = "orders",
      .title = "Return error after reversed motion",
      .caption = "Difference of a pendulum (amplitude 2.2 rad) from its initial state after 4 s forward and 4 s back.",
      .x = {.label = "step", .unit = "s", .log = true},
      .y = {.label = "return error", .unit = "rad, rad/s", .log = true}};
  for (const char* method : {"velocity_verlet", "central_difference", "euler_cromer", "rk4"}) {
    Series series{method, {}, {}, Style::linespoints};
    Convergence errors;
    for (const double steps : {160.0, 320.0, 640.0, 1280.0, 2560.0, 5120.0}) {
      const double step = 4.0 / steps;
      const Return found =
          there_and_back(pendulum, make_integrator(method), step, static_cast<long>(steps), false, findings);
      series.add(step, std::max(found.missed, 1e-17));
      errors.add(step, found.missed);
    }
    figure.series.push_back(series);
    const auto claim = findings.in(fmt::format("integrator.{}", method));
    if (std::string{method} == "euler_cromer")
      findings.expect_order("order of the return error, euler_cromer", errors.last(3), 0.9, 1.1,
                            "its error is odd in the step; the next order is still visible");
    if (std::string{method} == "rk4")
      findings.expect_order("order of the return error, rk4", errors.between(0.003, 0.03), 4.97, 5.02,
                            "the error of order 4 is even in the step and cancels; that of order 5 remains");
  }
  findings.figure(figure);
}

void run(Findings& findings, const Setup& setup) {
  const long steps = setup.coarse ? 1000 : reversal_steps;
  Table table{.name = "returns",
              .caption =
                  "Return error of each scene after 10 000 steps forward and back, and sqrt(2n) u G, the rounding of "
                  "all steps times the measured growth G of differences.",
              .columns = {"scene", "method", "return error", "sqrt(2n) u G", "G"}};
  for (const Reversible& one : reversible_scenes()) {
    for (const char* method : {"velocity_verlet", "central_difference"}) {
      const auto claim = findings.in(fmt::format("integrator.{}", method)), group = findings.in(one.name);
      const Return found =
          there_and_back(with_fault(one, setup), given(method, setup), one.step, steps, true, findings);
      findings.expect_round_off(
          {"returns", fmt::format("return error of {}, {}", one.name, method)}, found.missed, 0.0, 4.0 * found.rounding,
          "sqrt(2n) u G, times four for the several roundings of a step and the worst of the numbers");
      table.rows.push_back(
          cells("{} | {} | {:.1e} | {:.1e} | {:.0f}", one.name, method, found.missed, found.rounding, found.growth));
    }
  }
  if (setup.coarse) return;
  findings.table(table);
  check_orders(findings, reversible_scenes().front());
}

}  // namespace

Case definition() {
  return {.id = "time_reversal",
          .title = "Time reversal",
          .requirements = {{"A5", {"returns"}},
                           {"law.linear_spring_dashpot", {"bounce"}},
                           {"law.tension_only", {"cables"}},
                           {"Eq. 18", {"rolling"}}},
          .main_checks = {"return error of bounce, velocity_verlet", "return error of cables, velocity_verlet",
                          "return error of rolling, velocity_verlet", "order of the return error, rk4"},
          .source = "Hairer, Lubich & Wanner 2006, chapters V and IX",
          .faults = {{"runge_kutta_for_verlet", "Runge-Kutta instead of leapfrog",
                      "return error of bounce, velocity_verlet"},
                     {"euler_for_verlet", "semi-implicit Euler instead of leapfrog",
                      "return error of pendulum, velocity_verlet"},
                     {"a_little_damping", "a dashpot of 1e-6 N s/m", "return error of bounce, velocity_verlet"}},
          .run = run};
}

}  // namespace talus::verification::problems::time_reversal
