#include "solver/run/simulate.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "verification/problems/speed_accuracy/failure_rows.hpp"
#include "verification/study/impacts/disc_bounce.hpp"
#include "verification/study/scenes/cable_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// A disc of w = 1, v = 1 and damping ratio xi between two planes, with 3.7 of free travel.
Scene boxed(double xi) {
  SceneBuilder builder;
  constexpr double radius = 8.0, distance = 3.7;
  const LinearSpringDashpot law{1.0, 2.0 * xi, EndRule::clamped};
  const BodyId disc =
      builder.add(Body{.name = "disc", .mobility = Mobility::sliding_y, .mass = 1.0, .shape = Circle{radius}});
  for (const double side : {1.0, -1.0}) {
    const char* name = side > 0.0 ? "below" : "above";
    const BodyId plane = builder.add_fixed(name, HalfPlane{}, {0.0, -side * (radius + 0.5 * distance)},
                                           side > 0.0 ? 0.0 : std::numbers::pi);
    builder.add_contact(name, plane, disc, law);
  }
  Scene scene = builder.at_rest("Disc in a box");
  set_velocity(scene.model, scene.initial, disc, {0.0, -1.0}, 0.0);
  return scene;
}

/// ln of the speed after n bounces, and its largest magnitude after any of them.
struct Drift {
  double end{}, farthest{};
};

Drift ln_speed(const char* method, double eta, long bounces, double xi, Findings& findings) {
  Scene scene = boxed(xi);
  // Start off the middle, so that the phases of the steps at both walls differ.
  scene.initial.q[0] = 0.456 * eta;
  long done = 0;
  bool inside = false;
  Drift drift;
  const Until enough = [&](const State& seen) {
    const bool now = seen.mode[0] == UnilateralSpring::acting || seen.mode[1] == UnilateralSpring::acting;
    if (inside && !now) {
      ++done;
      drift.end = std::log(std::abs(seen.v[0]));
      keep_largest(drift.farthest, drift.end);
    }
    inside = now;
    return done == bounces;
  };
  const double longest = 20.0 * static_cast<double>(bounces);
  const RunEnd run = run_scene(scene, make_integrator(method), {eta, longest, longest, false}, findings, {}, enough);
  return run.finished && done == bounces ? drift : Drift{std::nan(""), std::nan("")};
}

/// Minimum of a cable's tension, and minimum of k x + c v while the cable is stretched without tension, k = 1.
struct Minima {
  double tension{}, let_go{};

  void inspect(const CableRunResult& run, double damping) {
    for (std::size_t i = 1; i < run.time.size(); ++i) {
      tension = std::min(tension, run.tension[i]);
      const bool free = run.elongation[i] > 0.0 && run.tension[i] == 0.0;
      if (free) let_go = std::min(let_go, run.elongation[i] + damping * run.end.v[0]);
    }
  }
};

/// (v^2 + w^2 x^2 (1 - eta^2/4))/2, w = 1, which velocity Verlet of w h = eta conserves during contact.
double kept_energy(const State& state, double radius, double eta) {
  const double x = radius - state.q[1];
  return 0.5 * (state.v[1] * state.v[1] + x * x * (1.0 - 0.25 * eta * eta));
}

}  // namespace

FailureFound check_many_rebounds(Findings& findings, const Setup& setup) {
  constexpr double eta = 0.1;
  const long bounces = setup.coarse ? 1000 : 10000, few = 8;
  const double euler = ln_speed("euler", eta, few, 0.0, findings).end / static_cast<double>(few);
  const Drift verlet = ln_speed("velocity_verlet", eta, bounces, setup.has("leaky_box") ? 1e-5 : 0.0, findings);
  const double contact = 0.5 * std::numbers::pi * eta;
  findings.expect_model("e to one: gain of ln v per bounce at w h = 0.1, euler", euler, contact, 0.5 * eta * eta,
                        "ln(1 + eta^2)/2 per step, pi/eta steps: pi eta/2; a bounce has one step more or fewer");
  findings.expect_truncation(
      "e to one: largest magnitude of ln v in all bounces in a box, velocity_verlet", verlet.farthest, 0.0,
      eta * eta / 8.0, 3.0,
      "the largest gain of one bounce. A change of the speed by a thousandth moves the phase of the next touch, 37 "
      "steps later, by a twenty-fifth of a step: neighbouring bounces are similar, and as areas are preserved their "
      "errors return instead of accumulating; from other initial states up to 2.1 times the bound was measured");
  return {fmt::format("Euler, w h = 0.1: ln v grows by {:.3f} per bounce", euler),
          fmt::format("Verlet, {} bounces: at most {:.4f}", bounces, verlet.farthest)};
}

FailureFound check_jump_at_touch(Findings& findings, const Setup& setup) {
  constexpr double xi = 0.2, tolerance = 1e-10;
  const double e = reference::restitution(xi, reference::EndRule::clamped);
  const Bounce b = bounce(e, EndRule::clamped, setup);
  const auto at = [&b](double gap) { return disc_at(b, gap); };
  const Integrator located = make_integrator("stormer_cowell", tolerance);
  const Integrator unlocated = setup.has("located") ? located : Integrator{VelocityVerlet{}};
  const double fails = impact_errors(at, b.exact, 50.0, unlocated, findings).restitution.rms();
  const double holds = impact_errors(at, b.exact, 50.0, located, findings).restitution.max();
  findings.expect(
      "jump at touch: rms error of e at 50 steps, xi = 0.2, steps not cut", fails, predicted_restitution_error(b, 50.0),
      Tolerance::model(2.0 * next_power,
                       "as predicted from jump and lag, 0.35/N; the next power of the step is 4 % at 100 steps")
          .relative());
  findings.expect_truncation("jump at touch: largest error of e, steps cut at the touch", holds, 0.0, tolerance, 3.0,
                             "the method's tolerance applies to one step, relative to the displacement and speed");
  return {fmt::format("steps not cut: {:.2f}/N of e (rms)", 50.0 * fails),
          fmt::format("cut at the touch: {:.1g}", holds)};
}

FailureFound check_snatch(Findings& findings, const Setup& setup) {
  constexpr double xi = 0.3, tolerance = 1e-10;
  const double used = setup.has("no_dashpot") ? 0.0 : xi;
  const reference::ImpactEvents exact =
      reference::impact_events({1.0, 2.0 * xi, 1.0, 1.0}, reference::EndRule::clamped);
  const Scene scene = thrown_mass(TensionOnly{1.0, 2.0 * used}, 1.0, 1.0);
  Minima minima;
  const auto error = [&](const Integrator& method, double steps, std::size_t phase) {
    const double step = offset_step(exact.contact_time, steps, phase);
    State state = scene.initial;
    state.q[0] -= even_phases(fewest_phases)[phase] * step;
    const CableRunResult run =
        run_cables(scene, state, method, {step, exact.contact_time + 2.0, false, true}, findings);
    minima.inspect(run, 2.0 * used);
    return std::abs(run.end.v[0]) / exact.restitution - 1.0;
  };
  PhaseError coarse, fine, located;
  for (std::size_t i = 0; i < fewest_phases; ++i) {
    coarse.add(error(VelocityVerlet{}, 50.0, i));
    fine.add(error(VelocityVerlet{}, 200.0, i));
    if (i % 8 == 0) located.add(error(make_integrator("stormer_cowell", tolerance), 50.0, i));
  }
  const double order = std::log(coarse.rms() / fine.rms()) / std::log(200.5 / 50.5);
  findings.expect_model("snatched cable: order of the return speed, steps not cut", order, 1.0, 0.05,
                        "the jump of the force and the lag of the dashpot; the next power of the step, w h = 0.05, "
                        "changes the order by half of that over two doublings");
  findings.expect_truncation("snatched cable: largest error of the return speed, steps cut", located.max(), 0.0,
                             tolerance, 3.0, "the method's tolerance");
  findings.expect_model("snatched cable: minimum of k x + c v while stretched without tension, over c e v0",
                        minima.let_go / (2.0 * xi * exact.restitution), -1.0, 0.04,
                        "the compression that an unclamped cable would exert at x = 0: one phase comes within a 64th "
                        "of a step of it, and e itself is off by up to 0.45/N");
  findings.expect_exact("snatched cable: minimum tension of all runs", minima.tension, 0.0,
                        "zero where the law is clamped");
  return {fmt::format("not cut: order {:.2f}; k x + c v falls to {:.2f} c e v0", order,
                      minima.let_go / (2.0 * xi * exact.restitution)),
          fmt::format("cut: {:.1g}; minimum T = {:g}", located.max(), minima.tension)};
}

FailureFound check_changed_step(Findings& findings, const Setup& setup) {
  constexpr double first = 0.1, radius = 8.0;
  const double second = setup.has("step_kept") ? first : 0.2;
  constexpr long before = 15, after = 5;  // steps; the contact lasts pi, so that the step changes about half-way
  Scene scene = scenes::bouncing_disc(
      {.radius = radius, .gap = 0.0, .speed = 1.0, .contact = LinearSpringDashpot{1.0, 0.0, EndRule::clamped}});
  const RunEnd half = run_steps(scene, VelocityVerlet{}, first, before, findings);
  scene.initial = half.state;
  scene.initial.t = 0.0;
  const RunEnd changed = run_steps(scene, VelocityVerlet{}, second, after, findings);
  const RunEnd kept = run_steps(scene, VelocityVerlet{}, first, after, findings);
  // The change of step changes the conserved energy, and so the energy with which the disc will leave.
  const double leaves = kept_energy(changed.state, radius, second), came = kept_energy(half.state, radius, first);
  const double x = radius - half.state.q[1];
  const double round_off = std::sqrt(20.0) * 8.0 * 0x1p-53;
  const char* why =
      "twenty steps with overlaps that are differences of lengths of 8, each rounded by 8.9e-16 at most: a random "
      "walk, twice that for the energy";
  findings.expect_round_off(
      {"change_of_step", "change of step: energy gain if the step is doubled half-way, over the energy at touch"},
      2.0 * (leaves - 0.5), 0.25 * x * x * (first * first - 0.04), 2.0 * round_off, why);
  findings.expect_round_off("change of step: energy gain with a constant step, over the energy at touch",
                            2.0 * (kept_energy(kept.state, radius, first) - 0.5), 0.0, 2.0 * round_off, why);
  findings.expect_round_off("change of step: energy gain until half-way, over the energy at touch", 2.0 * (came - 0.5),
                            0.0, 2.0 * round_off, why);
  constexpr double tolerance = 1e-10;
  Scene free = scenes::bouncing_disc(
      {.radius = radius, .gap = 0.3, .speed = 1.0, .contact = LinearSpringDashpot{1.0, 0.0, EndRule::clamped}});
  const RunEnd located = run_steps(free, make_integrator("stormer_cowell", tolerance), 1.0, 6);
  const double loss = located.state.v[1] * located.state.v[1] - 1.0;
  findings.expect_truncation("change of step: energy gain with variable steps cut at events, over the energy at touch",
                             loss, 0.0, tolerance, 3.0, "the method's tolerance");
  return {fmt::format("h doubled half-way: {:+.2f} % of the energy", 200.0 * (leaves - 0.5)),
          fmt::format("constant: {:.1g}; cut at events: {:.1g}",
                      std::abs(2.0 * (kept_energy(kept.state, radius, first) - 0.5)), std::abs(loss))};
}

/// Checks an overflow: the spring is so stiff, and is hit so fast, that its force overflows during the contact at any
/// step, however short. Each kind of method must report this and stop.
FailureFound check_overflow(Findings& findings, const Setup& setup) {
  const double huge = setup.has("soft_spring") ? 1.0 : 1e300;
  const auto outcome = [&](const char* method, double tolerance, double size) {
    const Scene scene = scenes::bouncing_disc(
        {.radius = 8.0, .gap = 0.3 * size, .speed = size, .contact = LinearSpringDashpot{size, 0.0, EndRule::clamped}});
    record_use(scene.model);
    const Dynamics dynamics{scene.model};
    RigidBodySystem system{dynamics};
    Integrator integrator = make_integrator(method, tolerance);
    State state = scene.initial;
    const Outcome end =
        simulate(system, integrator, state, {.step = 0.01, .end = 1.0, .interval = 0.01, .ledger = false});
    findings.count(system.evaluations());
    return end;
  };
  const Outcome fixed = outcome("velocity_verlet", 0.0, huge), located = outcome("stormer_cowell", 1e-10, huge),
                embedded = outcome("odeint_dopri5", 1e-10, huge);
  const auto gives_up = [](const Outcome& end) {
    return end.kind == Outcome::Kind::diverged && end.message.starts_with("no step is short enough") && end.time < 1.0;
  };
  findings.expect_true("overflow: error with the body's name, velocity Verlet",
                       fixed.kind == Outcome::Kind::diverged && fixed.message.find("disc") != std::string::npos,
                       "the force at 0.3 of the distance into the contact is 1e600");
  findings.expect_true("overflow: end of the run because no step is short enough, stormer_cowell", gives_up(located),
                       "a failed step is repeated with a shorter one, but not indefinitely");
  findings.expect_true("overflow: end of the run because no step is short enough, odeint_dopri5", gives_up(embedded),
                       "as for the solver's other method with step control");
  bool finished = true;
  for (const char* method : {"velocity_verlet", "stormer_cowell", "odeint_dopri5"})
    finished = finished && outcome(method, method[0] == 'v' ? 0.0 : 1e-10, 1.0).kind == Outcome::Kind::finished;
  findings.expect_true("overflow: no failure at a stiffness and speed of 1", finished, "the same scene");
  return {fmt::format("k = v = 1e300: diverged at {:.1g}, {:.1g} and {:.1g}", fixed.time, located.time, embedded.time),
          "k = v = 1: complete run"};
}

}  // namespace talus::verification::problems
