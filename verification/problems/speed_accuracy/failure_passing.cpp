#include "solver/geometry/penetration.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/stability/run_monitor.hpp"
#include "verification/problems/speed_accuracy/failure_rows.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

constexpr double radius = 1.0;
constexpr MonitorRules monitored{
    .instability = CheckAction::off, .tunnelling = CheckAction::error, .accuracy = CheckAction::off};
constexpr MonitorRules unmonitored{
    .instability = CheckAction::off, .tunnelling = CheckAction::off, .accuracy = CheckAction::off};

/// A run as by `talus run`, with RunMonitor checks before the first step and after each step.
struct WatchedRun {
  State end;
  std::string violation;             ///< empty if the run reached its end
  std::vector<std::string> lines{};  ///< of the monitor, as `talus run` prints them
};

WatchedRun watched_run(Scene scene, double step, double end, const MonitorRules& rules, Findings& findings) {
  scene.integrator = VelocityVerlet{};
  scene.plan = {step, end, end, false, rules};
  record_use(scene.model);
  record_use(scene.integrator);
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, false};
  WatchedRun run{scene.initial, {}};
  system.begin(run.end);
  RunMonitor watch{scene, dynamics, run.end};
  watch.check(Snapshot{dynamics, run.end}, 0);
  long n = 0;
  if (watch.violation().empty()) {
    (void)simulate(system, scene.integrator, run.end, scene.plan, {}, [&](const Snapshot& seen) {
      watch.check(seen, ++n);
      return !watch.violation().empty();
    });
  }
  findings.count(system.evaluations());
  run.violation = watch.violation();
  run.lines = watch_lines(watch, scene);
  return run;
}

/// A disc that flies at speed 1 towards a fixed disc of the same radius, at the distance `before` from touch.
Scene flight(double before, double frequency, double pull = 0.0) {
  SceneBuilder builder;
  builder.gravity({pull, 0.0});
  const BodyId post = builder.add(
      Body{.name = "post", .mobility = Mobility::fixed, .shape = Circle{radius}, .p_WB = {2.0 * radius + before, 0.0}});
  const BodyId stone = builder.add_particle("stone", 1.0, {}, Circle{radius});
  builder.add_contact("hit", post, stone, LinearSpringDashpot{frequency * frequency, 0.0, EndRule::clamped});
  Scene scene = builder.at_rest("Flight");
  set_velocity(scene.model, scene.initial, stone, {1.0, 0.0}, 0.0);
  return scene;
}

/// Two discs, the second twice as fast, that fly towards a fixed disc each, of the same radius and 18 r away.
Scene two_flights() {
  SceneBuilder builder;
  std::vector<BodyId> stones;
  for (const auto& [name, y] : {std::pair{"slow", 0.0}, {"fast", 10.0 * radius}}) {
    const BodyId post = builder.add_fixed(fmt::format("{}_post", name), Circle{radius}, {20.0 * radius, y});
    stones.push_back(builder.add_particle(fmt::format("{}_stone", name), 1.0, {0.0, y}, Circle{radius}));
    builder.add_contact(name, post, stones.back(), LinearSpringDashpot{0.25, 0.0, EndRule::clamped});
  }
  Scene scene = builder.at_rest("Two flights");
  set_velocity(scene.model, scene.initial, stones[0], {1.0, 0.0}, 0.0);
  set_velocity(scene.model, scene.initial, stones[1], {2.0, 0.0}, 0.0);
  return scene;
}

/// Checks the report of bodies that overlap at the start without a contact between them: of four discs in a row, half a
/// radius apart, the first five of six pairs, deepest first.
void check_undeclared(Findings& findings) {
  SceneBuilder builder;
  for (int i = 0; i < 4; ++i)
    builder.add_particle(fmt::format("disc{}", i), 1.0, {0.5 * radius * i, 0.0}, Circle{radius});
  Scene scene = builder.at_rest("Discs without contacts");
  scene.plan = {1.0, 1.0, 1.0};
  const Dynamics dynamics{scene.model};
  const RunMonitor watch{scene, dynamics, scene.initial};
  const std::vector<std::string>& said = watch.start_warnings();
  findings.expect_true("deep overlap: report of five of six pairs without a contact, with their overlaps",
                       said.size() == 5 &&
                           said[0].starts_with("at t = 0 bodies 'disc0' and 'disc1' overlap by 150 %") &&
                           said[4].starts_with("at t = 0 bodies 'disc1' and 'disc3' overlap by 100 %") &&
                           said[4].ends_with("; further pairs are not reported"),
                       "2 r less 0.5 r and r, over r; further pairs are counted, not reported");
  findings.expect_exact("deep overlap: pairs without a contact that overlap",
                        static_cast<double>(watch.undeclared_overlaps().size()), 6.0, "each two of four discs");
}

/// Number of phases, of 64, in which the disc passes through the other with its speed bit-identical.
int unseen_passes(double step, Findings& findings) {
  int passes = 0;
  for (const double phase : even_phases(fewest_phases)) {
    const WatchedRun run = watched_run(flight(phase * step, 0.5), step, 40.0 * radius, unmonitored, findings);
    passes += run.end.v[0] == 1.0 ? 1 : 0;
  }
  return passes;
}

/// Flights in one output interval by a method with step control, from 16 distances to the touch.
struct ControlledFlights {
  int passed = 0;      ///< of them, those in which the disc was not thrown back
  double error = 0.0;  ///< of the exit speed, the largest of those that were
};

/// No force acts before the touch, so that the error estimate of a step alone would allow any step.
ControlledFlights controlled_flights(const std::string& method, double tolerance, Findings& findings) {
  ControlledFlights found;
  for (int i = 0; i < 16; ++i) {
    Scene scene = flight(0.37 * radius * std::pow(1.4, i), 2.0);
    const double interval = 120.0 * radius;
    scene.integrator = make_integrator(method, tolerance);
    scene.plan = {.step = interval, .end = interval, .interval = interval};
    record_use(scene.integrator);
    const Dynamics dynamics{scene.model};
    RigidBodySystem system{dynamics, false};
    State state = scene.initial;
    system.begin(state);
    const Outcome outcome = simulate(system, scene.integrator, state, scene.plan);
    findings.count(system.evaluations());
    if (!outcome || state.v[0] > 0.0)
      ++found.passed;
    else
      keep_worst(found.error, state.v[0] + 1.0);
  }
  return found;
}

/// An upright bar that drifts to the right across a fixed horizontal bar.
Scene crossed(double height, ContactMethod method) {
  SceneBuilder builder;
  const BodyId level = builder.add_fixed("level", Rectangle{1.0, 0.125});
  const BodyId upright = builder.add(
      Body{.name = "upright", .mass = 1.0, .inertia = 1.0, .shape = Rectangle{0.125, 1.0}, .p_WB = {0.0, height}});
  builder.add(Contact{.name = "across",
                      .a = upright,
                      .b = level,
                      .law = LinearSpringDashpot{1.0, 0.0, EndRule::clamped},
                      .method = method});
  Scene scene = builder.at_rest("Crossed bars");
  set_velocity(scene.model, scene.initial, upright, {0.0625, 0.0}, 0.0);
  return scene;
}

/// Force of the scene's contact in the initial state.
double force(const Scene& scene) {
  const Dynamics dynamics{scene.model};
  Workspace work = dynamics.workspace();
  State state = scene.initial;
  dynamics.update_all(state, work);
  dynamics.begin(state, work);
  LawForces forces;
  dynamics.forces(state, work, forces);
  return forces.contacts[0];
}

/// Two bars that turn and approach each other, their centres `apart` [L], under gravity along y.
Scene approaching_bars(double apart, Vec2 spins, double gravity = 0.0) {
  SceneBuilder builder;
  builder.gravity({0.0, -gravity});
  const BodyId a = builder.add_free("a", 1.0, 1.0, Rectangle{2.0, 0.25});
  const BodyId b = builder.add_free("b", 1.0, 1.0, Rectangle{1.0, 0.125}, {0.0, apart});
  builder.add_contact("ab", a, b, LinearSpringDashpot{1.0, 0.0, EndRule::clamped});
  Scene scene = builder.at_rest("Bars");
  set_velocity(scene.model, scene.initial, a, {0.0, 0.75}, spins.x);
  set_velocity(scene.model, scene.initial, b, {0.0, -0.5}, spins.y);
  return scene;
}

/// Distances and spins at which the limits of a step for the bars are compared with their definition.
constexpr std::array bar_distances{0.3, 3.5, 20.0};
constexpr std::array bar_spins{Vec2{0.0, 0.0}, Vec2{3.0, 0.0}, Vec2{0.0, 3.0}, Vec2{0.0, -3.0}, Vec2{-2.0, 5.0}};

/// Largest speed at which the ends of the bars may approach each other [L/T].
double end_speed(Vec2 spins) { return 1.25 + 2.25 * std::abs(spins.x) + 1.125 * std::abs(spins.y); }

/// Largest relative error of the longest step permitted by the monitor and by located events, for two bars that turn
/// and approach each other, touching, close and far apart. The exact value is half the sum of their half widths over
/// the largest speed at which their ends may approach.
double spinning_error() {
  double worst = 0.0;
  for (const double apart : bar_distances) {
    for (const Vec2 spins : bar_spins) {
      Scene scene = approaching_bars(apart, spins);
      const double exact = 0.5 * (0.25 + 0.125) / end_speed(spins);
      const Dynamics dynamics{scene.model};
      RigidBodySystem system{dynamics, true};
      system.begin(scene.initial);
      std::vector<double> guards;
      for (const double horizon : {0.5 * exact, 2.0 * exact}) {
        const double found = system.guards(scene.initial, false, horizon, guards).longest_step;
        keep_largest(worst, found / std::min(horizon, exact) - 1.0);
      }
      Workspace work = dynamics.workspace();
      dynamics.update(scene.initial, work);
      keep_largest(worst, dynamics.longest_step(work) / exact - 1.0);
    }
  }
  return worst;
}

/// Largest relative error of the distance, over the exact one, by which the ends of the bars may approach each other in
/// the longest step of step control, with gravity and without: the distance of circles around the bars, or half the sum
/// of their half widths where that is more.
double safe_step_error() {
  double worst = 0.0;
  for (const double apart : bar_distances) {
    for (const Vec2 spins : bar_spins) {
      for (const double gravity : {0.0, 2.0}) {
        const Scene scene = approaching_bars(apart, spins, gravity);
        const Dynamics dynamics{scene.model};
        RigidBodySystem system{dynamics, true};
        State state = scene.initial;
        system.begin(state);
        const double h = system.safe_step(state, 1e3), allowed = std::max(0.5 * (0.25 + 0.125), apart - 2.25 - 1.125);
        keep_worst(worst, (end_speed(spins) + 0.5 * gravity * h) * h / allowed - 1.0);
        // A step that is slightly longer is limited as a much longer one, a shorter one not.
        keep_worst(worst, system.safe_step(state, 1.001 * h) / h - 1.0);
        keep_worst(worst, system.safe_step(state, 0.5 * h) / (0.5 * h) - 1.0);
      }
    }
  }
  return worst;
}

Figure pass_figure(Findings& findings) {
  Series found{"solver, monitor off", {}, {}, Style::points};
  for (const double distance : {0.9, 1.6, 2.7, 3.6, 4.4, 5.3, 6.1, 7.0, 7.8})
    found.add(distance, unseen_passes(distance * radius, findings) / static_cast<double>(fewest_phases));
  const Series exact = curve("1 - 4 r/(v h)", multiples(0.2, 0, 40),
                             [](double distance) { return std::max(0.0, 1.0 - 4.0 / std::max(distance, 1.0)); });
  return {.name = "passes",
          .title = "Undetected passages of discs through each other",
          .caption =
              "Fraction of 64 phases in which a disc passes through a fixed one of the same radius with bit-identical "
              "speed, against the distance travelled in a step. Beyond the line the monitor refuses the run.",
          .x = {.label = "v h / r", .min = 0.0, .max = 8.0},
          .y = {.label = "fraction of phases", .min = 0.0, .max = 0.6},
          .series = {exact, found},
          .lines = {{'x', 1.0, "refused"}}};
}

}  // namespace

FailureFound check_long_step(Findings& findings, const Setup& setup) {
  const MonitorRules rules = setup.has("not_watched") ? unmonitored : monitored;
  const WatchedRun beyond = watched_run(flight(20.0, 0.5), 1.1 * radius, 18.0, rules, findings);
  const WatchedRun within = watched_run(flight(20.0, 0.5), 0.9 * radius, 18.0, monitored, findings);
  findings.expect_true({"long_step/refused", "long step: refusal before the run at v h = 1.1 r, 20 r before the touch"},
                       !beyond.violation.empty() && beyond.end.t == 0.0,
                       "a step may carry the disc past the middle of the other one");
  findings.expect_true({"long_step/permitted", "long step: no refusal at v h = 0.9 r"}, within.violation.empty(),
                       "the disc is sampled on either side of the middle");
  // Gravity adds g h^2/2 to the distance travelled in the first step.
  constexpr double step = 0.8 * radius;
  const auto pulled = [&](double ratio) {
    const double pull = (ratio * radius - step) * 2.0 / (step * step);
    return watched_run(flight(20.0, 0.5, pull), step, step, rules, findings).violation;
  };
  findings.expect_true("long step: refusal at v h + g h^2/2 = 1.05 r, with v h = 0.8 r", !pulled(1.05).empty(),
                       "falling bodies pass each other sooner");
  findings.expect_true("long step: no refusal at v h + g h^2/2 = 0.95 r", pulled(0.95).empty(), "as without gravity");
  findings.expect_round_off(
      "long step: permitted step of rotating bars against half their widths over the speed of their ends, largest "
      "relative error",
      spinning_error(), 0.0, 1e-15, "about six operations");
  findings.expect_true(
      "long step: contact and numbers in the refusal of two flights, the second at v h = 1.5 r",
      watched_run(two_flights(), 0.75 * radius, 0.75 * radius, rules, findings).violation ==
          "at t = 0 the bodies of contact 'fast' may pass each other unseen: a step is 1.5 times the longest in which "
          "they cannot; it must be below 0.5",
      "the first disc travels 0.75 r in a step; the second r in half a unit of time");
  // Contacts of fewer than ten steps must be reported.
  const auto contact_of = [&](double steps) {
    const MonitorRules by{
        .instability = CheckAction::off, .tunnelling = CheckAction::off, .accuracy = CheckAction::error};
    return watched_run(flight(0.05, 2.0 * std::numbers::pi), 0.5 / steps, 1.0, by, findings).violation;
  };
  findings.expect_true("long step: refusal of a contact of 9.9 steps, but not of 10.1",
                       !contact_of(9.9).empty() && contact_of(10.1).empty(),
                       "half a period of the spring is half a unit of time");
  const int passes = unseen_passes(4.4 * radius, findings), seen = unseen_passes(3.6 * radius, findings);
  const double phases = static_cast<double>(fewest_phases);
  findings.expect_model(
      {"long_step/passages", "long step: fraction of 64 phases with undetected passage, monitor off, v h = 1.1 of 4 r"},
      passes / phases, 1.0 - 1.0 / 1.1, 1.0 / phases,
      "discs overlap along a distance of 4 r, and the other phases step over it; of 64 phases one more or fewer");
  findings.expect_exact(
      {"long_step/detected", "long step: undetected passages in 64 phases, monitor off, v h = 0.9 of 4 r"}, seen, 0.0,
      "no step is longer than the overlap");
  double worst_exit = 0.0;
  for (const std::string& method : integrator_names()) {
    if (!has_step_control(method)) continue;
    const auto claim = findings.in("integrator." + method);
    const ControlledFlights flights = controlled_flights(method, 1e-8, findings);
    findings.expect_exact(
        fmt::format("long step: {} with step control, impacts missed in 16 flights of one output interval", method),
        flights.passed, 0.0,
        "step control detects no error in free flight, so that steps must end where discs may have met: no impact is "
        "missed");
    if (method != "odeint_fehlberg78") {
      keep_worst(worst_exit, flights.error);
      continue;
    }
    // Fehlberg's estimate compares derivatives at the ends of the step alone: c = 0, 1, 0, 1.
    const ControlledFlights finer = controlled_flights(method, 1e-11, findings);
    findings.expect_model(
        "long step: odeint_fehlberg78 with step control, error of the exit speed at a thousandth of the tolerance over "
        "that at 1e-8",
        finer.error / flights.error, 1.0, 0.75,
        "its error estimate is a difference of derivatives at the two ends of a step and hardly detects a contact that "
        "begins within it: the tolerance has little effect");
  }
  findings.expect_model(
      "long step: exit speed with step control, largest error, methods with an error estimate in each stage",
      worst_exit, 0.0, 4e-5,
      "steps that enter the contact are half a radius long at most, and an estimate that detects the kink shortens "
      "them: a tenth of 4e-4, the error of Fehlberg's, which does not");
  findings.expect_round_off(
      "long step: approach in the longest step of step control over the allowed one, rotating bars, largest error",
      safe_step_error(), 0.0, 2e-15, "about ten operations");
  if (!setup.coarse) findings.figure(pass_figure(findings));
  return {fmt::format("v h = 1.1 r: refused at t = 0; monitor off, 4.4 r: {} of 64 pass", passes),
          fmt::format("v h = 0.9 r: not refused; monitor off, 3.6 r: {}", seen)};
}

FailureFound check_deep_overlap(Findings& findings, const Setup& setup) {
  const MonitorRules rules = setup.has("not_watched_either") ? unmonitored : monitored;
  const auto fall = [&](double ratio, const MonitorRules& by) {
    const double w = 1.0 / (ratio * 0.5 * radius);
    return watched_run(
        scenes::bouncing_disc(
            {.radius = radius, .gap = 0.1, .speed = 1.0, .contact = LinearSpringDashpot{w * w, 0.0, EndRule::clamped}}),
        0.005, 3.0, by, findings);
  };
  findings.expect_true({"deep_overlap/ended", "deep overlap: run ended during the impact at v/w = 1.1 of r/2"},
                       !fall(1.1, rules).violation.empty(), "the largest overlap is v/w");
  findings.expect_true({"deep_overlap/not_ended", "deep overlap: run not ended at v/w = 0.9 of r/2"},
                       fall(0.9, monitored).violation.empty(), "as for the previous check");
  const auto speed = [&](double ratio) {
    return watched_run(flight(0.1, 1.0 / (ratio * 2.0 * radius)), 0.005, 20.0, unmonitored, findings).end.v[0];
  };
  const double through = speed(1.1), back = speed(0.9);
  findings.expect_truncation(
      {"deep_overlap/through", "deep overlap: speed beyond the disc, v/w = 1.1 of 2 r, monitor off"}, through, 1.0,
      0.5 * 0.005 * 4.0 * radius / std::pow(2.2 * radius, 2) * std::sqrt(1.0 - 1.0 / 1.21), 1.0,
      "a spring compressed by 2 r absorbs all of v^2 if v/w = 2 r: above that, the disc leaves on the other side with "
      "its initial speed. At the middle the force jumps by 4 r w^2, at a time known to half a step, at which the speed "
      "is sqrt(1 - 1/1.21) v");
  findings.expect_truncation(
      {"deep_overlap/rebound", "deep overlap: speed after the rebound, v/w = 0.9 of 2 r, monitor off"}, back, -1.0,
      std::pow(0.005 / 1.8, 2) / 8.0, 1.0,
      "the disc reverses before the middle; the leapfrog changes the speed of a bounce by at most a fraction (w "
      "h)^2/8");
  check_undeclared(findings);
  return {fmt::format("v/w = 1.1 of r/2: ended; monitor off, 1.1 of 2 r: passes at {:.2f} v", through),
          fmt::format("v/w = 0.9 of r/2: not ended; monitor off, 0.9 of 2 r: {:.2f} v", back)};
}

FailureFound check_crossed_bars(Findings& findings, const Setup& setup) {
  const Scene plus = crossed(0.0, setup.has("one_resultant") ? ContactMethod::resultant : ContactMethod::nodes);
  const Scene corner = crossed(1.0625, ContactMethod::nodes);
  const std::vector<Body>& bodies = plus.model.bodies;
  const double overlap = penetration(bodies[0].shape, {}, bodies[1].shape, {});
  const WatchedRun silent = watched_run(plus, 0.125, 8.0, unmonitored, findings);
  const WatchedRun said = watched_run(plus, 0.125, 8.0, monitored, findings);
  findings.expect_exact(
      {"crossed_bars/crossing", "crossed bars: change of speed while crossing, by nodes, monitor off"},
      silent.end.v[0] - 0.0625, 0.0, "no node is inside, so that no force acts: this is the failure");
  findings.expect_exact({"crossed_bars/plus_by_nodes", "crossed bars: force of the plus by nodes"}, force(plus), 0.0,
                        "as for the previous check");
  findings.expect_true(
      {"crossed_bars/plus_overlap", "crossed bars: overlap reported before the run"},
      said.violation.find("no node of either is in the other") != std::string::npos && said.end.t == 0.0,
      "an overlap of 9 half widths that no node detects");
  const std::string label = "largest overlap unseen by nodes", at_start = " % at t = 0, 'across'";
  double percent = NAN;
  for (const std::string& line : said.lines)
    if (line.starts_with(label) && line.ends_with(at_start)) percent = std::stod(line.substr(label.size()));
  findings.expect_exact({"crossed_bars/printed", "crossed bars: overlap unseen by nodes, as printed"}, percent, 900.0,
                        "9/8 over the half width of both bars, 1/8, in percent; four digits give it exactly", "%");
  findings.expect_exact(
      {"crossed_bars/plus_minimum",
       "crossed bars: overlap of the plus, minimum over all directions, over the sum of the half sides"},
      overlap / 1.125, 1.0, "both are sums of powers of two");
  findings.expect_exact({"crossed_bars/plus_by_resultant", "crossed bars: force of the plus by one resultant"},
                        force(crossed(0.0, ContactMethod::resultant)), 2.25,
                        "at both ends of the side, k times the minimum overlap of the sides, 1.125");
  findings.expect_exact({"crossed_bars/corners_by_nodes", "crossed bars: force of two corners inside, by nodes"},
                        force(corner), 0.125, "two nodes, each with an overlap of 1/16");
  findings.expect_true({"crossed_bars/corners_unreported", "crossed bars: no report with corners inside"},
                       watched_run(corner, 0.125, 0.125, monitored, findings).violation.empty(),
                       "the nodes detect them");
  return {fmt::format("a plus, by nodes: F = {:g} k L at an overlap of {:g}; reported at t = 0", force(plus), overlap),
          fmt::format("corners inside: {:g} k L; one resultant: {:g}", force(corner),
                      force(crossed(0.0, ContactMethod::resultant)))};
}

}  // namespace talus::verification::problems
