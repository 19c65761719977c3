#include "solver/scenes/bouncing_disc.hpp"
#include "verification/problems/speed_accuracy/exact_motions.hpp"
#include "verification/problems/speed_accuracy/fence_exit.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::located_events {
namespace {

/// Maximum numbers of evaluations for errors of 1e-6 and 1e-9 on each of the motions, set before the method was
/// written.
struct Bound {
  double admitted[2];
  const char* reason;
};
constexpr Bound bounds[] = {
    {{1200.0, 3000.0}, "set in advance, below what any of odeint's steppers was known to take"},
    {{5000.0, 10000.0}, "set in advance, below what any of odeint's steppers was known to take"},
    {{900.0, 1800.0}, "set in advance, below what any of odeint's steppers was known to take"},
    {{4000.0, 4000.0},
     "set in advance, as a hundredth of the assumed cost of velocity Verlet for 1e-6; because of its order it takes "
     "more (case work_precision)"}};

/// Recorded numbers of evaluations, summed over all tolerances, on each of the motions and on the fence, from the last
/// deliberate change of the method. They are the same on every machine, so that a change of steps and orders is
/// detected here by its cost even if the errors remain within their tolerance.
constexpr double counted[] = {17320.0, 32456.0, 9787.0, 13147.0}, counted_on_fence = 15322.0;

void expect_counted(Findings& findings, const std::string& scene, double evaluations, double known) {
  findings.expect_between("evaluations for all tolerances over the recorded number, " + scene, evaluations / known,
                          0.995, 1.005,
                          "a count, not a time: 0.5 % is allowed for different rounding. A change of the method "
                          "requires new recorded numbers");
}

/// The method, or the one by which a fault replaces it.
Integrator method(const Setup& setup, double tolerance) {
  if (setup.has("no_events")) return make_integrator("odeint_fehlberg78", tolerance);
  return make_integrator("stormer_cowell", tolerance);
}

std::string whole(double number) { return std::isfinite(number) ? fmt::format("{:.0f}", number) : "not reached"; }

void check_motion(const ExactMotion& motion, const Bound& bound, double known, Findings& findings, const Setup& setup,
                  Table& table, Figure& figure) {
  std::vector<WorkPoint> points;
  double evaluations = 0.0;
  Series series{.label = motion.name};
  for (double tolerance = 1e-3; tolerance > 1e-12; tolerance /= std::sqrt(10.0)) {
    points.push_back(run_motion(motion, method(setup, tolerance), 1, findings));
    evaluations += static_cast<double>(points.back().evaluations);
    if (points.back().error > 0.0) {
      series.add(points.back().evaluations, points.back().error);
    }
  }
  figure.series.push_back(series);
  const double reached[] = {evaluations_to_reach(points, 1e-6), evaluations_to_reach(points, 1e-9)};
  const std::string reason = fmt::format(
      "{:.0f} and {:.0f} evaluations are permitted for 1e-6 and 1e-9: {}; fewer than a fiftieth would mean that "
      "evaluations are missing from the count",
      bound.admitted[0], bound.admitted[1], bound.reason);
  findings.expect_between(
      {"evaluations_to_1e_6", fmt::format("evaluations to reach 1e-6 over the permitted number, {}", motion.name)},
      reached[0] / bound.admitted[0], 0.02, 1.0, reason);
  findings.expect_between(
      {"evaluations_to_1e_9", fmt::format("evaluations to reach 1e-9 over the permitted number, {}", motion.name)},
      reached[1] / bound.admitted[1], 0.02, 1.0, reason);
  expect_counted(findings, motion.name, evaluations, known);
  const std::size_t last = points.size() - 1;
  const double digit = std::sqrt(points[last].evaluations / points[last - 4].evaluations);
  findings.expect_between(
      fmt::format("factor of evaluations for a tenth of the tolerance, {}", motion.name), digit,
      std::pow(10.0, 1.0 / 18.0), std::pow(10.0, 1.0 / 10.0),
      "over the last two digits; as a power of the step, 13 is expected at the highest order. 10 and 18 allow 5 % in "
      "either direction: orders and lengths are chosen step by step, and the motion differs from scene to scene");
  table.rows.push_back(cells("{} | {} | {} | {} | {:.3f} | {}", motion.name, whole(evaluations_to_reach(points, 1e-4)),
                             whole(reached[0]), whole(reached[1]), digit, points.back().events));
}

constexpr double early = 0.05, late = 0.2;  ///< ends of the fence's runs [s]
constexpr long spans = 2500;                ///< at whose ends the largest tension is sampled
constexpr double others_tolerance = 1e-13;  ///< of the steppers with which the best values are compared

/// Errors of tension and speed of the fence at decreasing tolerances, and their costs.
struct FenceErrors {
  std::vector<WorkPoint> tensions, speeds;
};

FenceErrors fence_errors(const FenceHit& hit, double end, const FenceExit& best, Findings& findings, const Setup& setup,
                         Table& table) {
  FenceErrors errors;
  for (double tolerance = 1e-3; tolerance > 1e-10; tolerance /= 10.0) {
    const char* name = setup.has("fence_without_events") ? "odeint_dopri5" : "stormer_cowell";
    const FenceExit found = run_fence(hit, make_integrator(name, tolerance), {end, spans}, findings);
    errors.tensions.push_back({std::abs(found.tension / best.tension - 1.0), found.evaluations, found.events});
    errors.speeds.push_back({std::abs(found.speed / best.speed - 1.0), found.evaluations, found.events});
    table.rows.push_back(cells("{:g} | {:.0e} | {} | {} | {:.0e} | {:.0e}", end, tolerance, found.evaluations,
                               found.events, errors.tensions.back().error, errors.speeds.back().error));
  }
  return errors;
}

/// Largest difference of the rock's speed from the best value for three methods that do not locate events and share
/// only the forces [ft/s].
double distance_of_others(const FenceHit& hit, double end, const FenceExit& best, Findings& findings) {
  double furthest = 0.0;
  for (const char* name : {"odeint_dopri5", "odeint_cash_karp54", "odeint_bulirsch_stoer"}) {
    const FenceExit found = run_fence(hit, make_integrator(name, others_tolerance), {end, spans}, findings);
    const double distance = std::abs(found.speed - best.speed);
    keep_worst(furthest, distance);
  }
  return furthest;
}

/// Checks the order of the scheme of 1993 at steps of at most 4e-6 s against the best value: events that are not
/// located make it first order.
void check_scheme_of_1993(const FenceHit& hit, const FenceExit& best, Findings& findings, const Setup& setup) {
  Convergence errors;
  constexpr int runs = 8;
  for (int steps = 8; steps <= (setup.tier == Tier::full ? 256 : 32); steps *= 2) {
    double squares = 0.0, mean = 0.0;
    for (int i = 0; i < runs; ++i) {
      const long count = std::lround(steps * std::exp2(static_cast<double>(i) / runs));
      const FenceExit found = run_fence(hit, make_integrator("central_difference"), {early, spans, count}, findings);
      squares += std::pow(found.speed - best.speed, 2) / runs;
      mean += early / static_cast<double>(spans) / static_cast<double>(count) / runs;
    }
    errors.add(mean, std::sqrt(squares));
  }
  findings.expect_order(
      "order of central_difference in the rock's speed at 0.05 s", errors, 0.6, 1.4,
      "events are late by up to a step: order 1. Root mean squares of 8 runs with steps spread over an octave, each "
      "uncertain by a fifth, which over two octaves changes the order by 0.2; twice that");
}

void check_fence(Findings& findings, const Setup& setup, Figure& figure) {
  const FenceHit hit = fence_hit();
  Table table{.name = "fence",
              .caption = "The fence of Table 2 by tolerance: errors of the largest tension and of the rock's speed.",
              .columns = {"end [s]", "tolerance", "evaluations", "events", "tension", "speed"}};
  double furthest = 0.0, evaluations = 0.0;
  for (const double end : {early, late}) {
    const FenceExit best = run_fence(hit, make_integrator("stormer_cowell", 1e-13), {end, spans}, findings);
    const FenceErrors errors = fence_errors(hit, end, best, findings, setup, table);
    Series series{.label = fmt::format("fence, {:g} s", end)};
    for (const WorkPoint& point : errors.speeds) {
      series.add(point.evaluations, point.error);
      evaluations += static_cast<double>(point.evaluations);
    }
    figure.series.push_back(series);
    const auto demand = [&](const char* what, double tension, double speed, double maximum) {
      const double found =
          std::max(evaluations_to_reach(errors.tensions, tension), evaluations_to_reach(errors.speeds, speed));
      findings.expect_between(
          {"fence_evaluations", fmt::format("fence, evaluations to reach {} over {:.0f}", what, maximum)},
          found / maximum, 0.1, 1.0,
          fmt::format("set in advance, for a method that locates events; the 1993 scheme takes {:.0f} steps of 2e-6 s; "
                      "fewer than a tenth would mean that evaluations are missing from the count",
                      end / 2e-6));
    };
    if (end == early) {
      demand("1e-5 of tension and 1.4e-4 of speed at 0.05 s", 1e-5, 1.4e-4, 561.0);
      demand("2e-7 of tension and 3e-6 of speed at 0.05 s", 2e-7, 3e-6, 1071.0);
      if (setup.coarse) return;
      check_scheme_of_1993(hit, best, findings, setup);
    } else {
      demand("7e-5 of speed at 0.2 s", 1.0, 7e-5, 2166.0);
    }
    keep_largest(furthest, distance_of_others(hit, end, best, findings));
  }
  expect_counted(findings, "fence", evaluations, counted_on_fence);
  findings.expect_truncation(
      {"odeint_steppers",
       "fence, speed of the rock at 0.05 and 0.2 s: largest difference of three odeint steppers at 1e-13"},
      furthest, 0.0, 100.0 * others_tolerance * std::abs(hit.scene.initial.v[hit.rock]), 1.0,
      "the error of a step is kept below 1e-13 of the rock's initial speed, and the errors of about ten thousand steps "
      "add up as a random walk: a hundred times that",
      "ft/s");
  findings.table(table);
}

/// Checks a grazing contact that is shorter than a step, of a disc that a constant force pulls away from a plane. With
/// w^2 = k/m and the speed v0 = sqrt(2 g d) at touch, x = (g/w^2)(cos w t - 1) + (v0/w) sin w t returns to zero after
/// (2/w) atan(v0 w/g); the parabola without contact takes 2 v0/g.
void check_grazing(Findings& findings) {
  constexpr double g = 2.0, k = 1e4, m = 1.0, radius = 0.5, gap = 1.0, end = 2.0, tolerance = 1e-11;
  const double w = std::sqrt(k / m);
  double worst = 0.0;
  for (const double depth : {1e-2, 1e-4, 1e-6}) {
    SceneBuilder builder;
    builder.gravity({0.0, g});
    const BodyId plane = builder.add_fixed("plane", HalfPlane{});
    const BodyId disc = builder.add_particle("disc", m, {0.0, radius + gap}, Circle{radius});
    builder.add_contact("graze", disc, plane, LinearSpringDashpot{k, 0.0, EndRule::clamped});
    Scene scene = builder.at_rest("Grazing disc");
    const double start = std::sqrt(2.0 * g * (gap + depth)), touch = std::sqrt(2.0 * g * depth);
    set_velocity(scene.model, scene.initial, disc, {0.3, -start}, 0.0);
    const RunEnd run = run_scene(scene, make_integrator("stormer_cowell", tolerance), {end, end, end, false}, findings);
    const double left = end - (start - touch) / g - 2.0 / w * std::atan(touch * w / g);
    keep_worst(worst, run.state.q[1] - (radius + touch * left + 0.5 * g * left * left));
  }
  findings.expect_truncation("position after a grazing contact: largest error of three overlaps", worst, 0.0,
                             2.0 * tolerance, 3.0,
                             "local errors below 1e-11 of the distance travelled, 2 m, about ten of random sign; a "
                             "missed contact changes the position by 1e-5 or more",
                             "m");
}

/// Checks which methods choose their own steps. A contact of half a period, pi, lasts a third of an output interval:
/// methods that choose their steps leave it with the speed 1, all others miss it.
void check_choice(Findings& findings) {
  const Scene scene = scenes::bouncing_disc(
      {.radius = 8.0, .gap = 0.3, .speed = 1.0, .contact = LinearSpringDashpot{1.0, 0.0, EndRule::clamped}});
  std::vector<Integrator> methods{make_integrator("odeint_dopri5", 1e-9)};
  for (const std::string& name : integrator_names())
    methods.push_back(make_integrator(name, needs_tolerance(name) ? 1e-9 : 0.0));
  double wrong = 0.0, choosing = 0.0;
  for (const Integrator& method : methods) {
    const RunEnd end = run_steps(scene, method, 10.0, 2, findings);
    const bool followed = std::abs(end.state.v[1] - 1.0) < 1e-6;
    if (followed != chooses_steps(method)) wrong += 1.0;
    choosing += followed ? 1.0 : 0.0;
  }
  findings.expect_between("methods that follow a contact between two outputs", choosing, 4.0,
                          static_cast<double>(methods.size()) - 5.0, "the list contains several methods of each kind");
  findings.expect_exact("methods wrongly reported as choosing or not choosing their steps", wrong, 0.0,
                        "compared with their behaviour");
}

/// Counts discs that do not rebound: a small disc is thrown fast at a small post from afar, and only the post can
/// shorten its steps. The disc comes from four sides, and either body is named first in the contact.
void check_posts(Findings& findings) {
  constexpr double radius = 0.05, distance = 10.0, speed = 100.0;
  double lost = 0.0;
  for (const Vec2 from : {Vec2{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
    for (const bool disc_first : {true, false}) {
      SceneBuilder builder;
      Body disc{.name = "disc", .mobility = Mobility::particle, .mass = 1.0, .shape = Circle{radius}};
      disc.p_WB = distance * from;
      const BodyId flying = builder.add(disc);
      const BodyId post = builder.add_fixed("post", Circle{radius});
      builder.add_contact("hit", disc_first ? flying : post, disc_first ? post : flying, LinearSpringDashpot{1e8, 0.0});
      Scene scene = builder.at_rest("Post");
      set_velocity(scene.model, scene.initial, flying, -speed * from, 0.0);
      const RunEnd end = run_steps(scene, make_integrator("stormer_cowell", 1e-6), 2.0 * distance / speed, 1, findings);
      if (!(dot(pose(scene.model, end.state, flying).v_WB, from) > 0.99 * speed)) lost += 1.0;
    }
  }
  findings.expect_exact("discs thrown at a post that do not rebound", lost, 0.0, "none of eight");
}

/// Checks a large disc that falls from rest on another, for so long that a step could last many seconds: only its
/// weight shortens the step. Then counts the events of a disc that bounces without loss.
void check_falls(Findings& findings) {
  constexpr double radius = 100.0, height = 1000.0, gravity = 9.81;
  const double fall = std::sqrt(2.0 * height / gravity);
  SceneBuilder builder{si};
  builder.gravity({0.0, -gravity});
  const BodyId falling = builder.add_particle("disc", 1.0, {0.0, 2.0 * radius + height}, Circle{radius});
  const BodyId post = builder.add_fixed("post", Circle{radius});
  builder.add_contact("hit", falling, post, LinearSpringDashpot{1e6, 0.0});
  Scene scene = builder.at_rest("Fall");
  const RunEnd end = run_steps(scene, make_integrator("stormer_cowell", 1e-6), 2.5 * fall, 1, findings);
  findings.expect_model(
      "velocity of a disc 2.5 fall times after its release above a large disc, over its impact speed",
      end.state.v[1] / (gravity * fall), -0.5, 1e-3,
      "the contact lasts pi sqrt(m/k) = 0.003 s of 14 s; a disc that has passed through continues to fall at 2.5");

  const Scene bouncing =
      scenes::bouncing_disc({.gap = 0.5, .gravity = gravity, .contact = LinearSpringDashpot{1e6, 0.0}});
  for (const char* const method : {"stormer_cowell", "exact"}) {
    const double tolerance = needs_tolerance(method) ? 1e-10 : 0.0;
    const RunEnd bounced = run_steps(bouncing, make_integrator(method, tolerance), 0.1, 30, findings);
    // The disc starts with a speed of 1, first touches at the time `first`, and each later flight lasts 2 u/g.
    const double u = std::sqrt(1.0 + 2.0 * gravity * 0.5), first = (u - 1.0) / gravity;
    const double bounces = std::floor((3.0 - first) / (2.0 * u / gravity)) + 1.0;
    findings.expect_exact(fmt::format("located events of a bouncing disc, {}", method),
                          static_cast<double>(talus::located_events(bounced.method).value_or(0)), 2.0 * bounces,
                          "each contact begins and ends");
  }
}

/// A row of six equal, taut cables between two walls, with five masses. One of the outer masses is thrown at its wall.
struct CableRow {
  static constexpr int masses = 5;
  static constexpr double mass = 1.0, stiffness = 4.0, length = 1.0, elongation = 0.2;

  /// Displacement at time t of an outer mass thrown with unit speed while all cables are taut, from the modes
  /// sin(j pi i/6) of the row.
  static double displacement(double t) {
    double sum = 0.0;
    for (int j = 1; j <= masses; ++j) {
      const double angle = std::numbers::pi * j / (masses + 1);
      const double w = 2.0 * std::sqrt(stiffness / mass) * std::sin(0.5 * angle);
      sum += 2.0 / (masses + 1) * std::pow(std::sin(masses * angle), 2) * std::sin(w * t) / w;
    }
    return sum;
  }

  /// Time of the first maximum of displacement().
  static double first_maximum() {
    constexpr double h = 1e-4;
    double t = 0.0;
    while (displacement(t + h) > displacement(t))
      t += h;
    return t;
  }

  static Scene scene(bool last, double speed) {
    SceneBuilder builder;
    std::vector<BodyId> ids;
    for (int i = 0; i < masses; ++i)
      ids.push_back(builder.add_particle(fmt::format("mass{}", i), mass, {(i - 0.5 * (masses - 1)) * length, 0.0}));
    for (int i = 0; i <= masses; ++i) {
      const CableEnd wall{{}, {(i == 0 ? -0.5 : 0.5) * (masses + 1) * length, 0.0}};
      builder.add_cable(fmt::format("cable{}", i), i == 0 ? wall : CableEnd{ids[static_cast<std::size_t>(i) - 1], {}},
                        i == masses ? wall : CableEnd{ids[static_cast<std::size_t>(i)], {}}, length - elongation,
                        ElasticPlastic{.stiffness = stiffness});
    }
    Scene made = builder.at_rest("Row of cables");
    set_velocity(made.model, made.initial, last ? ids.back() : ids.front(), {last ? speed : -speed, 0.0}, 0.0);
    return made;
  }
};

/// Checks a cable at the end of a row that slackens for less than a step: the last cable, or in the mirror image the
/// first. The bodies are numbered from left to right in both.
void check_rows(Findings& findings) {
  const double turn = CableRow::first_maximum();
  const double critical = CableRow::elongation / CableRow::displacement(turn);
  double wrong = 0.0, apart = 0.0;
  for (const double excess : {-1e-2, -1e-3, 1e-3, 3e-3, 1e-2}) {
    const auto run_row = [&](bool last) {
      const Scene scene = CableRow::scene(last, (1.0 + excess) * critical);
      const RunEnd run = run_steps(scene, make_integrator("stormer_cowell", 1e-6), 1.5 * turn, 1, findings);
      if (talus::located_events(run.method) != (excess > 0.0 ? 2 : 0)) wrong += 1.0;
      return run.state;
    };
    const State first = run_row(false), last = run_row(true);
    for (std::size_t i = 0; i < CableRow::masses; ++i)
      keep_worst(apart, last.q[2 * i] + first.q[2 * (CableRow::masses - 1 - i)]);
  }
  findings.expect_exact(
      "runs of a row of cables that miss an outer cable which slackens for a moment, or find one that does not", wrong,
      0.0, "both events of three speeds, none of two; the last and the first cable");
  findings.expect_round_off("positions in a row of cables against its mirror image, largest difference", apart, 0.0,
                            1e-12, "the same steps; sums of a hundred steps in another order of the masses");
}

void run(Findings& findings, const Setup& setup) {
  if (!setup.coarse) check_grazing(findings), check_choice(findings), check_posts(findings), check_falls(findings);
  if (!setup.coarse) check_rows(findings);
  Table table{.name = "evaluations",
              .caption =
                  "Evaluations to reach an error; their factor for a tenth of the tolerance, over the last two digits; "
                  "located events.",
              .columns = {"motion", "1e-4", "1e-6", "1e-9", "factor", "events"}};
  Figure figure{.name = "work_precision",
                .title = "Error against force evaluations, located events",
                .caption =
                    "Each line is one scene with tolerances from 1e-3 to 1e-12. Dashed: order 2, for which ten times "
                    "the evaluations give two digits.",
                .x = {.label = "force evaluations", .unit = "1", .log = true},
                .y = {.label = "error", .unit = "1", .log = true},
                .series = {},
                .slopes = {{-2.0, 2000.0, 1e-3, "order 2"}}};
  const std::vector<ExactMotion> motions = exact_motions();
  for (std::size_t i = 0; i < motions.size(); ++i)
    check_motion(motions[i], bounds[i], counted[i], findings, setup, table, figure);
  check_fence(findings, setup, figure);
  if (setup.coarse) return;
  findings.table(table);
  findings.figure(figure);
}

}  // namespace

Case definition() {
  return {.id = "located_events",
          .title = "Located events: variable-order steps",
          .family = "speed and accuracy",
          .requirements = {{"integrator.stormer_cowell",
                            {"evaluations_to_1e_6", "evaluations_to_1e_9", "fence_evaluations"}}},
          .main_checks = {"evaluations to reach 1e-6 over the permitted number, pendulum, 90 degrees",
                          "evaluations to reach 1e-9 over the permitted number, pendulum, 170 degrees",
                          "evaluations to reach 1e-9 over the permitted number, two cables",
                          "evaluations to reach 1e-9 over the permitted number, damped bounce",
                          "factor of evaluations for a tenth of the tolerance, two cables", "odeint_steppers",
                          "fence, evaluations to reach 7e-5 of speed at 0.2 s over 2166"},
          .source = "Stoermer 1907; Cowell & Crommelin 1910; Krogh 1974; Shampine & Gordon 1975; Alefeld et al. 1995",
          .faults = {{"no_events", "Fehlberg 7(8) with step control, which does not stop at events",
                      "evaluations to reach 1e-6 over the permitted number, damped bounce"},
                     {"fence_without_events", "Dormand-Prince 5 with step control, which does not stop at events",
                      "fence, evaluations to reach 2e-7 of tension and 3e-6 of speed at 0.05 s over 1071"}},
          .full_seconds = 7.0,
          .run = run};
}

}  // namespace talus::verification::problems::located_events
