#include "solver/integrate/advance.hpp"
#include "verification/problems/friction/method_run.hpp"
#include "verification/reference/motion/held_body.hpp"
#include "verification/reference/motion/smooth_motion.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::prescribed_motion {
namespace {

/// The solver's system with an external acceleration on its first three coordinates, a function of time.
///
/// The time is the position of a clock, a particle of the scene that moves at speed 1 without forces: each method
/// therefore evaluates the function at the time of its positions, in every stage.
class ForcedSystem {
 public:
  using Forcing = std::function<reference::Triple(double t)>;

  /// `clock`: index of the coordinate that is the time.
  ForcedSystem(const Dynamics& dynamics, std::size_t clock, Forcing forcing)
      : system_{dynamics, false}, clock_{clock}, forcing_{std::move(forcing)}, rates_{rest_state(dynamics.model())} {}

  void drift(State& state, double h) { system_.drift(state, h); }
  void kick(State& state, double h) {
    evaluate(state, rates_);
    kick_velocities(state, rates_, h);
  }
  void begin(State& state) { system_.begin(state); }
  void update_modes(State& state) { system_.update_modes(state); }
  void derivative(const State& state, Rates& out) {
    system_.derivative(state, out);
    add(state, out);
  }
  void evaluate(State& state, Rates& out) {
    system_.evaluate(state, out);
    add(state, out);
  }
  long evaluations() const { return system_.evaluations(); }

 private:
  void add(const State& state, Rates& out) const {
    const reference::Triple extra = forcing_(state.q[clock_]);
    for (std::size_t i = 0; i < extra.size(); ++i)
      out.v[i] += static_cast<double>(extra[i]);
  }

  RigidBodySystem system_;
  std::size_t clock_;
  Forcing forcing_;
  Rates rates_;
};

constexpr double end_time = 4.0;

/// A prescribed motion, the springs of the body that performs it, and the same body as a model of the solver.
struct Exercise {
  std::string name;
  reference::SmoothSystem springs;
  reference::PrescribedMotion motion;
  Model model;
  std::size_t clock{};  ///< index of its coordinate

  reference::Triple forcing(double t) const { return reference::forcing(springs, motion, t); }
};

/// Adds the particle whose position is the time. It is the last body and has two coordinates.
void add_clock(SceneBuilder& builder) { builder.add_particle("clock", 1.0); }

std::vector<reference::Tie> cables(bool damped) {
  const double c = damped ? 1.0 : 0.0;
  return {{-0.5, 0.2, -4.0, 1.0, 2.0, 40.0, 0.8 * c},
          {0.5, 0.2, 4.0, 1.5, 2.2, 70.0, 0.5 * c},
          {0.1, -0.3, 0.3, -4.0, 2.5, 30.0, 0.3 * c}};
}

Exercise on_cables(bool damped, const Setup& setup) {
  constexpr double mass = 2.0, inertia = 0.6;
  Exercise out;
  out.name = damped ? "cables with dashpots" : "cables";
  out.springs = reference::body_on_cables(mass, inertia, cables(damped));
  out.motion.coordinates = {reference::Wave{0.0, 0.0, {{0.3, 1.3, 0.2}}}, reference::Wave{0.0, 0.0, {{0.25, 1.7, 1.0}}},
                            reference::Wave{0.0, 0.2, {{0.6, 0.9, 0.5}}}};
  SceneBuilder builder;
  const BodyId body = builder.add(Body{.name = "body", .mass = mass, .inertia = inertia});
  int number = 0;
  for (const reference::Tie& tie : cables(damped)) {
    const double at = setup.has("cables_on_the_centre") ? 0.0 : 1.0;
    const double stiffness = setup.has("cables_stiffer") ? 1.001 * tie.stiffness : tie.stiffness;
    builder.add_cable(fmt::format("cable_{}", ++number), {body, {at * tie.body_x, at * tie.body_y, 0.0}},
                      {std::nullopt, {tie.anchor_x, tie.anchor_y, 0.0}}, tie.rest_length,
                      TensionOnly{stiffness, tie.damping});
  }
  add_clock(builder);
  out.model = builder.build();
  out.clock = 3;
  return out;
}

constexpr double post_radius = 1.0, roller_radius = 0.5, rho = 1.45, breath = 0.02, breath_rate = 2.9, nod = 0.3,
                 first_stretch = 0.01, about = 2.0 * std::numbers::pi / end_time;

reference::PrescribedMotion rolling_motion() {
  const double arm = 0.5 * (roller_radius - post_radius + rho), spin = about * rho / arm;
  const double w = breath_rate, half = 0.5 * breath, quarter = 0.5 * std::numbers::pi;
  reference::PrescribedMotion motion;
  motion.coordinates = {
      reference::Wave{0.0, 0.0, {{rho, about, quarter}, {half, w + about, 0.0}, {half, w - about, 0.0}}},
      reference::Wave{0.0, 0.0, {{rho, about, 0.0}, {half, w - about, quarter}, {-half, w + about, quarter}}},
      reference::Wave{0.0, spin, {{nod, w, 0.0}}}};
  motion.memory = [=](reference::Real t) {
    const reference::Real s = std::sin(w * t), c = 1.0L - std::cos(w * t);
    const reference::Real passed = about * (rho * t + breath / w * c);
    const reference::Real rolled = arm * (spin * t + nod * s) + half * (spin / w * c + 0.5L * nod * s * s);
    return reference::Memories{first_stretch + passed - rolled, 0.0L};
  };
  return motion;
}

Exercise rolling(const Setup& setup) {
  const reference::PressedDisc disc{.radius = roller_radius,
                                    .mass = 1.0,
                                    .inertia = 0.1,
                                    .normal_stiffness = 80.0,
                                    .slip_stiffness = 50.0,
                                    .weight = 0.0,
                                    .posts = {{0.0, 0.0, post_radius}}};
  Exercise out;
  out.name = "rolling";
  out.springs = reference::pressed_disc(disc);
  out.motion = rolling_motion();
  SceneBuilder builder;
  const BodyId roller = builder.add_free("roller", disc.mass, disc.inertia, Circle{disc.radius}, {rho, 0.0});
  const BodyId post = builder.add_fixed("post", Circle{post_radius});
  const double softer = setup.has("friction_softer") ? 0.999 : 1.0;
  builder.add_contact("touch", roller, post, LinearSpringDashpot{disc.normal_stiffness, 0.0},
                      CoulombFriction{50.0, softer * disc.slip_stiffness});
  add_clock(builder);
  out.model = builder.build();
  out.clock = 3;
  return out;
}

/// Norm of positions, velocities and history variable, all of order 1.
double size(const reference::SmoothState& state) {
  reference::Real sum = state.z[0] * state.z[0];
  for (std::size_t i = 0; i < 3; ++i)
    sum += state.q[i] * state.q[i] + state.v[i] * state.v[i];
  return static_cast<double>(std::sqrt(sum));
}

/// Distance of the solver's final state from the prescribed motion.
double error(const Exercise& exercise, const Integrator& method, long steps, Findings& findings, const Setup& setup) {
  record_use(exercise.model);
  const Dynamics dynamics{exercise.model};
  ForcedSystem system{dynamics, exercise.clock, [&](double t) { return exercise.forcing(t); }};
  const double step = end_time / static_cast<double>(steps);
  State state = rest_state(exercise.model);
  const reference::SmoothState start = exercise.motion.at(0.0L), exact = exercise.motion.at(end_time);
  for (std::size_t i = 0; i < 3; ++i) {
    state.q[i] = static_cast<double>(start.q[i]);
    state.v[i] = static_cast<double>(start.v[i]);
  }
  state.v[exercise.clock] = 1.0;
  if (setup.has("clock_half_a_step_late")) state.q[exercise.clock] = -0.5 * step;
  if (!state.z.empty() && !setup.has("memory_forgotten")) state.z[0] = static_cast<double>(start.z[0]);
  state = run_method(system, method, state, step, steps);
  findings.count(system.evaluations());
  reference::SmoothState off;
  for (std::size_t i = 0; i < 3; ++i) {
    off.q[i] = state.q[i] - exact.q[i];
    off.v[i] = state.v[i] - exact.v[i];
  }
  if (!state.z.empty()) off.z[0] = state.z[0] - exact.z[0];
  return size(off);
}

Convergence errors(const Exercise& exercise, const Integrator& method, double first, std::size_t count,
                   Findings& findings, const Setup& setup) {
  Convergence found;
  for (const double n : doublings(first, count))
    found.add(end_time / n, error(exercise, method, std::lround(n), findings, setup));
  return found;
}

struct Method {
  const char* name;
  reference::Leapfrog kind;
};

constexpr Method leapfrogs[] = {{"velocity_verlet", reference::Leapfrog::velocity_verlet},
                                {"central_difference", reference::Leapfrog::central_difference},
                                {"lagged_central_difference", reference::Leapfrog::lagged_central_difference},
                                {"euler_cromer", reference::Leapfrog::euler_cromer}};

void check_leapfrogs(const Exercise& exercise, Figure& figure, Findings& findings, const Setup& setup) {
  const reference::SmoothSystem system = reference::forced(exercise.springs, exercise.motion);
  for (const Method& method : leapfrogs) {
    if (setup.coarse && method.kind != reference::Leapfrog::velocity_verlet) continue;
    const std::string name = exercise.name + ", " + method.name;
    const auto claim = findings.in(fmt::format("integrator.{}", method.name));
    const int order = reference::order(method.kind, system);
    const double first = setup.coarse ? 256.0 : order == 1 ? 2048.0 : 1024.0;
    const Convergence found = errors(exercise, make_integrator(method.name), first, 3, findings, setup);
    const auto leading =
        reference::leading_error(system, exercise.motion.at(0.0L), end_time, method.kind, setup.coarse ? 200 : 600);
    const double constant = size(leading);
    // The half drifts at the start and at the end have other midpoints than the full drifts between them: the history
    // variable of a staggered method has one more error term, of order 3.
    const bool odd = order == 1 || (exercise.name == "rolling" && method.kind != reference::Leapfrog::velocity_verlet);
    expect_constant(findings.in(exercise.springs.damped ? "cables" : exercise.name), name, found, constant, order,
                    odd ? 1 : 2, setup.coarse ? 2e-4 : 3e-6);
    if (method.kind == reference::Leapfrog::velocity_verlet)
      findings.expect_order(
          "order, " + name, found, order - 0.003, order + 0.003,
          "the order of the method, because no cable or contact is released; the next power, w h = 0.03 (w = 8, at the "
          "largest step; squared without dashpots), bends the line by a twentieth of itself");
    if (method.kind == reference::Leapfrog::lagged_central_difference && !system.damped) continue;
    figure.series.push_back({name, found.steps(), found.errors(), Style::points});
    figure.series.push_back(curve("predicted", found.steps(), [&](double h) { return constant * std::pow(h, order); }));
  }
}

/// A method of higher order, with a first number of steps for which its order is visible above round-off.
struct HighOrder {
  const char* name;
  double order, first;
  bool rolling_only;  ///< on the cables the error reaches round-off before its leading term dominates
};

constexpr HighOrder high_orders[] = {{"rk4", 4, 256, false},
                                     {"odeint_dopri5", 5, 256, false},
                                     {"odeint_cash_karp54", 5, 128, true},
                                     {"odeint_fehlberg78", 8, 40, true}};

void check_high_orders(const Exercise& exercise, Figure& figure, Findings& findings, const Setup& setup) {
  for (const HighOrder& method : high_orders) {
    if (method.rolling_only && exercise.name != "rolling") continue;
    const auto claim = findings.in(fmt::format("integrator.{}", method.name));
    const Convergence found = errors(exercise, make_integrator(method.name), method.first, 3, findings, setup);
    findings.expect_order(fmt::format("order, {}, {}", exercise.name, method.name), found, method.order - 0.2,
                          method.order + 0.2,
                          "the order of the method, because no cable or contact is released; the next power, w h = 0.1 "
                          "to 0.8 for w = 8 at the largest step, times a constant of the method: at most 0.19 is "
                          "measured, and it decreases with the step");
    figure.series.push_back({exercise.name + ", " + method.name, found.steps(), found.errors(), Style::linespoints});
  }
}

Figure figure_of(const char* name, const char* title, const char* caption) {
  return {.name = name, .title = title, .caption = caption, .x = {"step", "1", true}, .y = {"error", "1", true}};
}

void run(Findings& findings, const Setup& setup) {
  Figure high =
      figure_of("high", "Prescribed motions, methods of higher order", "Error of the final state against the step.");
  for (const Exercise& exercise : {on_cables(false, setup), on_cables(true, setup), rolling(setup)}) {
    if (setup.coarse && exercise.springs.damped) continue;
    const std::string file = exercise.springs.damped ? "cables_with_dashpots" : exercise.name;
    Figure figure = figure_of(file.c_str(), ("Prescribed motion: " + exercise.name).c_str(),
                              "Error of position, velocity and history variable at the end, combined in quadrature, "
                              "against the step. Lines: prediction, no constant fitted.");
    check_leapfrogs(exercise, figure, findings, setup);
    if (setup.coarse) continue;
    findings.figure(figure);
    check_high_orders(exercise, high, findings, setup);
  }
  if (!setup.coarse) findings.figure(high);
}

}  // namespace

Case definition() {
  return {.id = "prescribed_motion",
          .title = "Prescribed motion: elastic cables and history-dependent friction",
          .requirements = {{"law.tension_only, Eq. 13, Eq. 14, Eq. 15", {"cables"}},
                           {"Eq. 18, C8, law.linear_spring_dashpot, shape.circle", {"rolling"}}},
          .main_checks = {"error over its prediction, cables, velocity_verlet",
                          "error over its prediction, cables with dashpots, velocity_verlet",
                          "error over its prediction, rolling, velocity_verlet", "order, rolling, rk4"},
          .source = "Derived here; the method: Roache 2002, J. Fluids Eng. 124, 4-10",
          .faults = {{"cables_stiffer", "cables 0.1 % stiffer", "error over its prediction, cables, velocity_verlet"},
                     {"cables_on_the_centre", "cables attached at the centre of mass",
                      "error over its prediction, cables, velocity_verlet"},
                     {"friction_softer", "tangential spring 0.1 % softer",
                      "error over its prediction, rolling, velocity_verlet"},
                     {"memory_forgotten", "tangential spring unstretched at the start",
                      "error over its prediction, rolling, velocity_verlet"},
                     {"clock_half_a_step_late", "prescribed force half a step late",
                      "error over its prediction, rolling, velocity_verlet"}},
          .run = run};
}

}  // namespace talus::verification::problems::prescribed_motion
