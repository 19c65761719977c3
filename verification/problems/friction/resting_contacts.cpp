#include "solver/io/read_scene_file.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "verification/check/case_file.hpp"
#include "verification/reference/friction/resting_contact.hpp"
#include "verification/study/runs/recorded_run.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::resting_contacts {
namespace {

constexpr double gravity = 9.81;
constexpr reference::SlidingBlock block{10.0, 0.25, 0.25, 1e6, 1e6, 0.3, gravity, 3.0};
constexpr reference::RollingDisc disc{2.0, 0.01, 0.1, 1e6, 1e6, gravity, std::numbers::pi / 9.0};
constexpr double nudge = 1e-3;  ///< [m/s]; stretches the springs to 15 % of the friction limit

Scene scene_of(const char* file, const Setup& setup) {
  Scene scene = read_scene(case_file(file));
  auto& friction = std::get<CoulombFriction>(*scene.model.contacts[0].friction);
  if (setup.has("no_shear_dashpot")) friction.follows_normal = false;
  if (setup.has("inertia_too_large")) scene.model.bodies[1].inertia *= 1.0 + 1e-5;
  if (setup.has("friction_too_large")) friction.coefficient *= 1.0 + 1e-6;
  return scene;
}

/// The block at its static height with a small initial speed. It cannot rotate, so that only friction stops it.
Scene nudged_block(const Setup& setup) {
  Scene scene = scene_of("sliding_block.toml", setup);
  scene.model.bodies[1].mobility = Mobility::particle;
  scene.model.bodies[1].inertia = 0.0;
  scene.initial = rest_state(scene.model);
  scene.initial.q[1] -= block.mass * gravity / (2.0 * block.normal_stiffness);
  scene.initial.v[0] = nudge;
  scene.plan.end = 1.0;
  return scene;
}

struct Ended {
  State state;
  long evaluations{};
  Accounts accounts;
  double balance{};  ///< largest error of the energy balance [N m]
  std::vector<double> time, speed;
};

/// Runs the scene as `talus run` does.
Ended ended(Scene scene, double tolerance, Findings& findings) {
  scene.integrator = make_integrator("stormer_cowell", tolerance);
  Ended found;
  const RecordedRun run{scene, findings, [&](const State& seen, const StepInfo& info) {
                          if (!info.due) return;
                          found.time.push_back(seen.t);
                          found.speed.push_back(std::hypot(seen.v[0], seen.v[1]));
                        }};
  found.state = run.end().state;
  found.evaluations = run.end().evaluations;
  found.accounts = run.recorder().accounts();
  found.balance = run.recorder().ledger()->largest_energy_balance_error();
  return found;
}

/// A system with an empty linearization, so that all steps are explicit.
struct ExplicitSystem : RigidBodySystem {
  using RigidBodySystem::RigidBodySystem;
  void linearization(const State&, LinearSegment&) {}
};

/// Number of evaluations of a scene with explicit steps alone, at most 20,000.
long explicit_evaluations(const Scene& scene, double tolerance, Findings& findings) {
  const Dynamics dynamics{scene.model};
  ExplicitSystem system{dynamics};
  system.allow(20'000);
  StormerCowell method;
  method.tolerance = tolerance;
  State state = scene.initial;
  system.begin(state);
  try {
    method.start(system, state, scene.plan.step);
    while (state.t < scene.plan.end && method.failure().empty())
      method.step(system, state, scene.plan.step);
  } catch (const TooManyEvaluations&) {
    // More evaluations than the check allows.
  }
  findings.count(system.evaluations());
  return system.evaluations();
}

/// Number of force evaluations of the scenes against the tolerance.
struct Costs {
  Series block{"block sliding to rest", {}, {}, Style::linespoints};
  Series disc{"rolling disc", {}, {}, Style::linespoints};
};

void sliding_block(Findings& findings, const Setup& setup, Costs& costs) {
  const Scene scene = scene_of("sliding_block.toml", setup);
  const double expected = reference::stopped_displacement(block);
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    if (setup.coarse && tolerance != 1e-6 && tolerance != 1e-10) continue;
    const bool explicitly = setup.has("explicit_steps");
    if (explicitly && tolerance != 1e-6) continue;
    const Ended found = explicitly ? Ended{} : ended(scene, tolerance, findings);
    const long evaluations = explicitly ? explicit_evaluations(scene, tolerance, findings) : found.evaluations;
    costs.block.add(tolerance, static_cast<double>(evaluations));
    const std::string name = fmt::format("block, tolerance {:.0e}: ", tolerance);
    findings.expect_between(
        name + "evaluations", static_cast<double>(evaluations), 100.0, 300.0 * (-std::log10(tolerance) - 3.0),
        "at 1e-6 a method of order 4 covers the slide in tens of steps of five stages, and start and stop are "
        "transients of about 15 periods; each decimal adds a fixed number: 300 per decimal beyond three");
    if (explicitly) continue;
    findings.expect_truncation(name + "displacement", found.state.q[0], expected, 0.1 * tolerance, 3.0,
                               "a tenth of the tolerance times the displacement is measured at 1e-6 and 1e-10", "m");
    findings.expect_truncation(
        name + "speed at rest", std::hypot(found.state.v[0], found.state.v[1]), 0.0, 0.3 * tolerance * block.speed, 1.0,
        "errors of the method are relative to the largest speed, 3 m/s; a third is measured", "m/s");
    findings.expect_truncation(name + "largest error of the energy balance", found.balance, 0.0,
                               4.0 * tolerance * 0.5 * block.mass * block.speed * block.speed, 3.0,
                               "speeds have an error of the tolerance at every step, and the friction work is the "
                               "integral of its power; four times the tolerance is measured",
                               "N m");
  }
  if (setup.coarse) return;
  Scene longer = scene;
  longer.plan.end *= 10.0;
  const Ended rested = ended(longer, 1e-6, findings);
  findings.expect_between("block: evaluations during 18 s at rest",
                          static_cast<double>(rested.evaluations) - costs.block.y.front(), 0.0, 100.0,
                          "steps that grow fivefold each cover any duration in a few steps of six evaluations");
}

void rolling_disc(Findings& findings, const Setup& setup, Costs& costs) {
  const Scene scene = scene_of("rolling_disc.toml", setup);
  const double cosine = std::cos(disc.angle), sine = std::sin(disc.angle), end = scene.plan.end;
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    if (setup.coarse && tolerance != 1e-8) continue;
    const Ended found = ended(scene, tolerance, findings);
    costs.disc.add(tolerance, static_cast<double>(found.evaluations));
    const std::string name = fmt::format("disc, tolerance {:.0e}: ", tolerance);
    const double along =
        (found.state.q[0] - scene.initial.q[0]) * cosine - (found.state.q[1] - scene.initial.q[1]) * sine;
    const std::string why =
        "the disc starts with an overlap of 0.3 instead of 18 micrometres: the arm of friction is longer by half of "
        "that during the oscillation of 5 ms, 9e-5 of the arm for 0.5 % of the time";
    findings.expect_model(name + "displacement", along, reference::rolled_displacement(disc, end), 9e-5 * 5e-3 / 10.0,
                          why, "m");
    findings.expect(name + "spin", found.state.v[2], -reference::rolled_spin(disc, end),
                    Tolerance::model(9e-5 * 5e-3 / 10.0, why).relative(), "rad/s");
    findings.expect_between(name + "evaluations", static_cast<double>(found.evaluations), 100.0,
                            300.0 * (-std::log10(tolerance) - 3.0), "as for the block");
  }
}

/// A scene whose springs, along the normal and along the surface, are stiffer by a factor; damping ratios are the same.
Scene stiffer(const char* file, double factor, const Setup& setup) {
  Scene scene = scene_of(file, setup);
  Contact& contact = scene.model.contacts[0];
  auto& law = std::get<LinearSpringDashpot>(contact.law);
  law.stiffness *= factor, law.damping *= std::sqrt(factor);
  std::get<CoulombFriction>(*contact.friction).stiffness *= factor;
  return scene;
}

/// Evaluations with other springs: sliding and rolling must not cost more because contacts oscillate faster.
void check_stiffness(Findings& findings, const Setup& setup) {
  const auto group = findings.in("stiffness");
  for (const auto& [name, file] : {std::pair{"block", "sliding_block.toml"}, {"disc", "rolling_disc.toml"}}) {
    const auto evaluations = [&, scene = file](double factor) {
      return static_cast<double>(ended(stiffer(scene, factor, setup), 1e-10, findings).evaluations);
    };
    const auto [fewest, maximum] = std::minmax({evaluations(0.1), evaluations(1.0), evaluations(100.0)});
    group->expect_between(
        fmt::format("{}, 0.1 to 100 times the stiffness, tolerance 1e-10: most over fewest evaluations", name),
        maximum / fewest, 1.0, 2.0,
        "1,000 times the stiffness has 32 times as many oscillations; a method that followed a "
        "thirtieth of them would need twice the evaluations");
  }
}

void nudged(Findings& findings, const Setup& setup) {
  const Ended found = ended(nudged_block(setup), 1e-10, findings);
  const double energy = 0.5 * block.mass * nudge * nudge;
  const double friction = found.accounts.dissipated[static_cast<std::size_t>(Mechanism::friction)];
  findings.expect_truncation({"nudged_work", "nudged block: friction work over its kinetic energy"}, friction / energy,
                             1.0, 1e-10, 1.0,
                             "the power of the dashpot is integrated to the tolerance, 1e-10, over about 10 periods");
  findings.expect_truncation({"nudged_speed", "nudged block: speed at rest"},
                             std::hypot(found.state.v[0], found.state.v[1]), 0.0, 1e-10 * nudge, 3.0,
                             "errors of the method are relative to the largest speed", "m/s");
  if (setup.coarse) return;
  Scene undamped = nudged_block(setup);
  std::get<CoulombFriction>(*undamped.model.contacts[0].friction).follows_normal = false;
  const double frequency = std::sqrt(2.0 * block.shear_stiffness / block.mass);
  findings.expect_truncation(
      {"undamped_nudge", "nudged block without a tangential dashpot: speed after 1 s over the initial one"},
      ended(undamped, 1e-10, findings).state.v[0] / nudge, std::cos(frequency * undamped.plan.end),
      1e-10 * frequency * undamped.plan.end, 1.0,
      "an undamped oscillation on the springs of two corners, 71 periods; its phase errs by up to the tolerance times "
      "the angle, 447");
}

/// A disc that spins and bounces, with a tangential dashpot so strong that it carries most of the friction: the spring
/// force exceeds the friction limit while the dashpot acts in the opposite direction.
void strong_dashpot(Findings& findings) {
  const Scene scene = read_scene(R"(
title = "Disc with a strong dashpot along the ground"
units = "SI"
[[body]]
name = "disc"
mobility = "free"
mass = "10 kg"
inertia = "1.25 kg m^2"
shape = { kind = "circle", radius = "0.5 m" }
position = ["0 m", "0.51 m"]
velocity = ["0 m/s", "-2 m/s"]
spin = "2 rad/s"
[[body]]
name = "ground"
mobility = "fixed"
shape = { kind = "half_plane" }
position = ["0 m", "0 m"]
[[contact]]
name = "impact"
between = ["disc", "ground"]
law = "linear_spring_dashpot"
stiffness = "200 kN/m"
restitution = 0.6
friction = 1.0
shear_damping = "30000 N s/m"
[run]
end = "0.2 s"
)",
                                 "strong_dashpot");
  const double energy = 0.5 * 10.0 * 2.0 * 2.0 + 0.5 * 1.25 * 2.0 * 2.0;
  const Ended found = ended(scene, 1e-10, findings);
  findings.expect_truncation("strong dashpot: error of the energy balance at the end",
                             found.accounts.energy_balance_error / energy, 0.0, 1e-10, 1.0,
                             "the powers are integrated to the tolerance, 1e-10, in about 100 steps");
  const double lost = found.accounts.dissipated[static_cast<std::size_t>(Mechanism::friction)];
  findings.expect_between(
      "strong dashpot: friction work over the initial energy", lost / energy, 0.0, 0.3,
      "friction dissipates at most the energy of the spin, including what it transfers to the centre");
}

/// A body without contacts or forces, by every method with a tolerance: without motion there is no error to estimate.
void unmoved(Findings& findings) {
  SceneBuilder builder{si};
  builder.add_free("disc", 2.0, 0.01, Circle{0.1}, {1.0, 2.0});
  Scene scene = builder.at_rest();
  double moved = 0.0, maximum = 0.0;
  for (const std::string& name : integrator_names()) {
    if (!takes_tolerance(integrator_traits(name).step_control)) continue;
    const RunEnd end = run_scene(scene, make_integrator(name, 1e-10), {1.0, 1.0, 1.0, true}, findings);
    for (std::size_t i = 0; i < end.state.q.size(); ++i)
      keep_worst(moved, std::abs(end.state.q[i] - scene.initial.q[i]) + std::abs(end.state.v[i]));
    maximum = std::max(maximum, static_cast<double>(end.evaluations));
  }
  const auto group = findings.in("unmoved");
  findings.expect_exact("body without forces: displacement and speed, largest of all methods", moved, 0.0,
                        "sums of zeros", "m, m/s");
  findings.expect_between("body without forces: evaluations of 1 s, maximum over the methods", maximum, 1.0, 26.0,
                          "without motion no step is too long: one step, or two of Fehlberg's thirteen evaluations");
}

/// A smooth disc, which spins, and a rough one, which does not, start from rest on one slope: friction acts on the
/// contact that has it alone, whichever is listed first.
void smooth_beside_rough(Findings& findings) {
  constexpr double spin = 3.0, end = 0.5;
  constexpr long steps = 5000;
  const double along = gravity * std::sin(disc.angle), down = gravity * std::cos(disc.angle);
  double smooth_moved = 0.0, smooth_spin = 0.0, rough_moved = 0.0;
  for (const std::size_t rough : {0U, 1U}) {
    SceneBuilder builder{si};
    builder.gravity({along, -down});
    const BodyId plane = builder.add_fixed("plane", HalfPlane{});
    for (const std::size_t i : {0U, 1U}) {
      const BodyId id =
          builder.add_free(fmt::format("disc{}", i), disc.mass, disc.inertia, Circle{disc.radius},
                           {static_cast<double>(i), disc.radius - disc.mass * down / disc.normal_stiffness});
      Contact touch{.name = fmt::format("touch{}", i),
                    .a = id,
                    .b = plane,
                    .law = LinearSpringDashpot{disc.normal_stiffness, 0.0}};
      if (i == rough) touch.friction = CoulombFriction{0.4, disc.shear_stiffness};
      builder.add(std::move(touch));
    }
    Scene scene = builder.at_rest("A smooth and a rough disc");
    const std::size_t at_smooth = rough == 0 ? 3 : 0, at_rough = 3 - at_smooth;
    scene.initial.v[at_smooth + 2] = spin;
    const State found = run_steps(scene, VelocityVerlet{}, end / steps, steps, findings).state;
    const auto moved = [&](std::size_t at) { return found.q[at] - scene.initial.q[at]; };
    keep_worst(smooth_moved, moved(at_smooth) / (0.5 * along * end * end) - 1.0);
    keep_worst(smooth_spin, found.v[at_smooth + 2] / spin - 1.0);
    keep_worst(rough_moved, moved(at_rough) - reference::rolled_displacement(disc, end));
  }
  const auto group = findings.in("smooth_beside_rough");
  group->expect_round_off("smooth disc beside a rough one: displacement, largest relative error", smooth_moved, 0.0,
                          1e-12, "5000 additions to positions of up to 1.4 m, over 0.4 m");
  group->expect_exact("smooth disc beside a rough one: spin, largest relative change", smooth_spin, 0.0,
                      "no force on it has a moment about its centre");
  const double q = disc.inertia / (disc.mass * disc.radius * disc.radius);
  const double stretch = q / (1.0 + q) * disc.mass * along / disc.shear_stiffness;
  group->expect_model("rough disc beside a smooth one: displacement, largest error", rough_moved, 0.0,
                      1.5 * q / (1.0 + q) * stretch,
                      "without a dashpot its friction spring oscillates about the stretch s of rolling, and its centre "
                      "by q s/(1 + q); half of that is allowed for the change of its arm",
                      "m");
}

/// Draws the speed of the block with and without the tangential dashpot.
void draw_speeds(Findings& findings, const Setup& setup) {
  Scene scene = scene_of("sliding_block.toml", setup);
  scene.plan.interval = scene.plan.step;
  const auto curve = [&](const char* label) {
    const Ended found = ended(scene, 1e-10, findings);
    Series series{label, {}, {}, Style::lines};
    for (std::size_t i = 0; i < found.time.size(); ++i) {
      if (found.time[i] < 1.015 || found.time[i] > 1.1) continue;
      series.add(found.time[i], std::max(found.speed[i], 1e-12));
    }
    return series;
  };
  const Series damped = curve("with a tangential dashpot");
  std::get<CoulombFriction>(*scene.model.contacts[0].friction).follows_normal = false;
  const Series undamped = curve("without a tangential dashpot");
  findings.figure({.name = "rest",
                   .title = "Speed of the block when it stops",
                   .caption = "The block stops at 1.0194 s and its springs recover. Without a tangential dashpot only "
                              "its rocking is damped.",
                   .x = {.label = "time", .unit = "s"},
                   .y = {.label = "speed of the centre", .unit = "m/s", .log = true},
                   .series = {damped, undamped},
                   .lines = {{'x', reference::stopping_time(block), "stop"}}});
}

void run(Findings& findings, const Setup& setup) {
  Costs costs;
  if (setup.concerns({"friction_too_large", "explicit_steps"})) sliding_block(findings, setup, costs);
  if (setup.concerns({"inertia_too_large"})) rolling_disc(findings, setup, costs);
  if (setup.concerns({"no_shear_dashpot"})) nudged(findings, setup);
  if (setup.fault.empty()) strong_dashpot(findings);
  if (setup.coarse) return;
  check_stiffness(findings, setup);
  draw_speeds(findings, setup);
  findings.figure(
      {.name = "cost",
       .title = "Force evaluations against the tolerance",
       .caption = "Force evaluations of the whole run. With explicit steps only, the block takes 1.6 million at 1e-6.",
       .x = {.label = "tolerance", .log = true},
       .y = {.label = "force evaluations", .log = true, .min = 100.0, .max = 1e4},
       .series = {costs.block, costs.disc}});
  if (!setup.coarse) unmoved(findings), smooth_beside_rough(findings);
}

}  // namespace

Case definition() {
  return {
      .id = "resting_contacts",
      .title = "Sliding to rest and resting contacts",
      .family = "C: friction and rotation",
      .requirements = {{"Eq. 18", {"block, tolerance 1e-10: displacement"}},
                       {"integrator.stormer_cowell", {"block, tolerance 1e-10: evaluations", "stiffness"}},
                       {"mechanism.friction", {"nudged_work"}},
                       {"regime.friction.sticking",
                        {"disc, tolerance 1e-08: displacement", "nudged_work", "nudged_speed", "undamped_nudge"}},
                       {"regime.friction.slipping_backward", {"block, tolerance 1e-10: displacement"}},
                       {"pair.rectangle.half_plane", {"block, tolerance 1e-10: displacement"}},
                       {"pair.circle.half_plane", {"disc, tolerance 1e-08: spin"}}},
      .main_checks = {"block, tolerance 1e-10: displacement", "block, tolerance 1e-06: evaluations",
                      "block, tolerance 1e-10: speed at rest", "disc, tolerance 1e-08: displacement", "nudged_work"},
      .source = "Kennedy & Carpenter 2003 (implicit steps); the springs of bodies at rest are derived here",
      .faults = {{"friction_too_large", "a coefficient of friction too large by 1e-6",
                  "block, tolerance 1e-10: displacement"},
                 {"inertia_too_large", "a moment of inertia of the disc too large by 1e-5",
                  "disc, tolerance 1e-08: spin"},
                 {"explicit_steps", "a system without linearization, so that all steps are explicit",
                  "block, tolerance 1e-06: evaluations"},
                 {"no_shear_dashpot", "no tangential dashpot while the contact sticks", "nudged_speed"}},
      .run = run};
}

}  // namespace talus::verification::problems::resting_contacts
