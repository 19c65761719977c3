#include "solver/dynamics/closed_form.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "verification/reference/impacts/damped_bounce.hpp"
#include "verification/reference/impacts/latching_impact.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/reference/many_bodies/struck_row.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::exact_segments {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Result and cost of a run.
struct Ran {
  State state;
  long evaluations{};
  long events{};
  bool finished{};
};

Ran ran(const Scene& scene, const Integrator& method, double end, int outputs, Findings& findings,
        const Watcher& watch = {}, bool ledger = false) {
  const double interval = end / outputs;
  const RunEnd run = run_scene(scene, method, {interval, end, interval, ledger}, findings, watch);
  return {run.state, run.evaluations, talus::located_events(run.method).value_or(0), run.finished};
}

/// The exact propagator, or the method by which a fault replaces it.
Integrator exact(const Setup& setup) {
  return setup.has("odeint_for_exact") ? make_integrator("odeint_fehlberg78", 1e-12) : make_integrator("exact");
}

EndRule rule_of(reference::EndRule end) {
  return end == reference::EndRule::clamped ? EndRule::clamped : EndRule::attractive;
}

void check_bounce(Findings& findings, const Setup& setup, Table& table) {
  constexpr double w = 100.0, xi = 0.2, end = 3.0;
  constexpr int outputs = 240;
  const reference::DampedBounce drop{w, xi, 9.81, 0.618, 1.0, reference::EndRule::clamped};
  const double stiffness = setup.has("stiffness_by_1e-9") ? (1.0 + 1e-9) * w * w : w * w;
  const Scene scene = scenes::bouncing_disc(
      {.mass = 1.0,
       .radius = 1.0,
       .gap = drop.gap,
       .speed = drop.speed,
       .gravity = drop.gravity,
       .contact = LinearSpringDashpot{stiffness, 2.0 * xi * w,
                                      setup.has("other_end_rule") ? EndRule::attractive : EndRule::clamped}});
  std::vector<double> times;
  for (int i = 1; i <= outputs; ++i)
    times.push_back(end * i / outputs);
  const auto truth = reference::bounce_states(drop, times);
  double position = 0.0, speed = 0.0;
  Series gap{.label = "gap", .style = Style::lines};
  const Watcher compare = [&](const State& seen, const StepInfo& info) {
    gap.add(seen.t, seen.q[1] - 1.0);
    if (info.step == 0) return;
    const auto& exact_state = truth[static_cast<std::size_t>(info.step - 1)];
    keep_largest(position, seen.q[1] - 1.0 - exact_state.gap);
    keep_largest(speed, seen.v[1] + exact_state.velocity);
  };
  const Ran found = ran(scene, exact(setup), end, outputs, findings, compare);
  const auto contacts = reference::bounces(drop, 100);
  // One flight; then for each contact that ends: the push, the exit without force, and the next flight.
  const double pieces = 2.0 + 3.0 * static_cast<double>(contacts.size() - 1);
  const std::string reason = fmt::format(
      "segments of the reference: {} contacts, the last of which does not end; one flight, and for each other contact "
      "its loading and unloading, the exit during which the clamped law exerts no force, and a flight",
      contacts.size());
  findings.expect_exact({"rest_evaluations", "damped bounce to rest: force evaluations"},
                        static_cast<double>(found.evaluations), pieces, reason);
  findings.expect_between(
      {"rest/permitted", "damped bounce to rest: force evaluations over the permitted 60"},
      static_cast<double>(found.evaluations) / 60.0, 0.02, 1.0,
      "60 was set in advance; a result below a fiftieth would mean that evaluations are missing from the count");
  // Overlap at rest g/w^2 = 1e-3, largest overlap 0.036; positions are stored at about 1 from the origin.
  const double rounding = epsilon / (contacts.front().largest_depth);
  findings.expect_round_off({"rest_position", "damped bounce to rest: position, largest error over the drop height"},
                            position / drop.gap, 0.0, 4.0 * rounding,
                            "eight positions at events, each rounded by half an epsilon of 1, relative to the overlap "
                            "of 0.036 that determines the impact");
  findings.expect_round_off(
      {"rest/velocity", "damped bounce to rest: velocity, largest error over the speed of the first impact"},
      speed / contacts.front().start_speed, 0.0, 8.0 * rounding,
      "as for the position; if an output falls within a contact, a time error of 1e-16 changes the velocity by w times "
      "as much");
  table.rows.push_back(
      {"damped bounce", fmt::format("{:.0f}", pieces), fmt::format("{}", found.evaluations),
       fmt::format("{:.1e}", position / drop.gap),
       fmt::format("{}", ran(scene, make_integrator("stormer_cowell", 1e-9), end, 1, findings).evaluations)});
  const Ran at_once = ran(scene, exact(setup), end, 1, findings);
  findings.expect_exact({"rest/one_output", "damped bounce to rest: force evaluations with one output"},
                        static_cast<double>(at_once.evaluations), pieces,
                        "outputs are evaluated from the segments and cost no evaluation");
  if (setup.coarse) return;
  Figure figure{.name = "bounce",
                .title = "Damped bounce to rest with one force evaluation per segment",
                .caption = fmt::format("Gap at {} outputs of a run of {} force evaluations. Crosses: events.", outputs,
                                       found.evaluations),
                .x = {.label = "time", .unit = "s"},
                .y = {.label = "gap", .unit = "m"},
                .series = {gap}};
  Series events{.label = "start and end of contact", .style = Style::crosses};
  for (const auto& contact : contacts) {
    events.add(contact.start_time, 0.0);
    if (std::isfinite(contact.end_time)) events.add(contact.end_time, 0.0);
  }
  figure.series.push_back(events);
  findings.figure(figure);
}

void check_impacts(Findings& findings, const Setup& setup, Table& table) {
  double worst = 0.0, worst_lost = 0.0;
  long evaluations = 0, runs = 0, stormer = 0, pieces = 0;
  for (const auto end : {reference::EndRule::attractive, reference::EndRule::clamped}) {
    for (const double xi : {0.0, 0.05, 0.2, 0.5, 0.9, 1.0, 2.0}) {
      const double e = reference::restitution(xi, end);
      if (e == 0.0) continue;  // no rebound
      const double damping = setup.has("dashpot_by_1e-9") ? (1.0 + 1e-9) * 200.0 * xi : 200.0 * xi;
      const Scene scene =
          scenes::bouncing_disc({.gap = 0.1, .speed = 1.0, .contact = LinearSpringDashpot{1e4, damping, rule_of(end)}});
      const Ran found = ran(scene, exact(setup), 1.0, 1, findings);
      keep_largest(worst, found.state.v[1] - e);
      evaluations += found.evaluations, ++runs;
      // Flight, push, flight; under the clamped rule the force ends before the disc has left, which adds a segment.
      pieces += end == reference::EndRule::clamped && xi > 0.0 ? 4 : 3;
      stormer += ran(scene, make_integrator("stormer_cowell", 1e-9), 1.0, 1, findings).evaluations;
      const Ran kept = ran(scene, exact(setup), 1.0, 1, findings, {}, true);
      double lost = 0.0;
      for (const double work : kept.state.work)
        lost += work;
      keep_largest(worst_lost, lost - 0.5 * (1.0 - e * e));
    }
  }
  findings.expect_exact("impacts: force evaluations in total", static_cast<double>(evaluations),
                        static_cast<double>(pieces), "one per segment");
  const double rounding = epsilon / (0.01 * std::exp(-1.0));
  findings.expect_round_off({"exit_speed", "impacts: exit speed, largest error over the entry speed"}, worst, 0.0,
                            rounding,
                            "positions about 1 from the origin are rounded by up to epsilon in total, relative to the "
                            "overlap v/w = 0.01, which damping reduces by e^-1");
  findings.expect_round_off({"dashpot_work", "impacts: work of the dashpots, largest error over twice the energy"},
                            worst_lost, 0.0, 2.0 * rounding, "the energy is quadratic in the speed");
  table.rows.push_back(cells("{} impacts | {} | {} | {:.1e} | {}", runs, pieces, evaluations, worst, stormer));
}

void check_latching(Findings& findings, const Setup& setup, Table& table) {
  double worst = 0.0, worst_time = 0.0;
  long evaluations = 0, stormer = 0, runs = 0;
  struct Latch {
    double back;
    double growth;
  };
  for (const Latch latch : {Latch{1.0, 0.0}, {2.0, 0.0}, {4.0, 0.0}, {16.0, 0.0}, {1.0, 1.0}, {2.0, 8.0}}) {
    const auto truth = reference::latching_events({1.0, latch.back, latch.growth, 1.0, 1.0});
    const LatchingSpring law{1.0, latch.back, setup.has("growth_lost") ? 0.0 : latch.growth};
    const Scene scene = scenes::bouncing_disc({.radius = 4.0, .gap = 0.25, .speed = 1.0, .contact = law});
    const double end = 0.25 + truth.contact_time + 1.0;
    const Ran found = ran(scene, exact(setup), end, 1, findings);
    keep_largest(worst, found.state.v[1] - truth.restitution);
    // The force ends at the residual overlap, after which the disc flies for a time of 1.
    keep_largest(worst_time, found.state.q[1] - 4.0 + truth.residual_depth - truth.restitution);
    evaluations += found.evaluations, ++runs;
    stormer += ran(scene, make_integrator("stormer_cowell", 1e-9), end, 1, findings).evaluations;
  }
  const std::string reason =
      "positions up to 4 from the origin are rounded by up to 4 epsilon, three times until the end";
  findings.expect_round_off({"latching_exit", "latching springs: exit speed, largest error"}, worst, 0.0,
                            12.0 * epsilon, reason);
  findings.expect_round_off(
      {"latching_position", "latching springs: position a time of 1 after the end, largest error"}, worst_time, 0.0,
      12.0 * epsilon, reason);
  table.rows.push_back(cells("{} latching springs | - | {} | {:.1e} | {}", runs, evaluations, worst, stormer));
}

Scene row_scene(const reference::StruckRow& row) {
  SceneBuilder builder;
  std::array<BodyId, 3> discs{};
  for (int i = 0; i < 3; ++i)
    discs[static_cast<std::size_t>(i)] = builder.add(Body{.name = fmt::format("disc{}", i + 1),
                                                          .mobility = Mobility::sliding_x,
                                                          .mass = row.mass,
                                                          .shape = Circle{4.0},
                                                          .p_WB = {8.0 * (i - 1) + (i == 2 ? row.gap : 0.0), 0.0}});
  const LinearSpringDashpot law{row.stiffness, 0.0, EndRule::clamped};
  builder.add_contact("first", discs[0], discs[1], law);
  builder.add_contact("second", discs[1], discs[2], law);
  Scene scene = builder.at_rest("Three discs on a line");
  set_velocity(scene.model, scene.initial, discs[0], {row.speed, 0.0}, 0.0);
  return scene;
}

void check_rows(Findings& findings, const Setup& setup, Table& table) {
  double worst = 0.0, pieces = 0.0;
  long evaluations = 0, stormer = 0;
  for (const double gap : {0.0, 0.1, 0.4, 1.2}) {
    const reference::StruckRow row{1.0, 1.0, 1.0, gap};
    const auto truth = reference::rebound(row);
    const Ran found = ran(row_scene(row), exact(setup), truth.end_time + 1.0, 1, findings);
    for (std::size_t i = 0; i < 3; ++i)
      keep_largest(worst, found.state.v[i] - truth.velocity[i]);
    evaluations += found.evaluations;
    pieces += static_cast<double>(truth.changes.size());
    stormer +=
        ran(row_scene(row), make_integrator("stormer_cowell", 1e-9), truth.end_time + 1.0, 1, findings).evaluations;
  }
  findings.expect_round_off({"three_discs", "three discs on a line: velocities, largest error"}, worst, 0.0,
                            24.0 * epsilon,
                            "positions 8 from the origin are rounded by half of 8 epsilon, for two discs in each of "
                            "three changes of contact");
  table.rows.push_back(cells("4 rows of three discs | {:.0f} | {} | {:.1e} | {}", pieces, evaluations, worst, stormer));
}

/// A touching pair, and the deviation of its overlap from a linear function of its coordinates: the largest second
/// difference over all pairs of coordinates [m]; NaN if there are no coordinates.
struct Pair {
  Model model;
  double bend{};
};
Pair touching(const Body& a, const Body& b) {
  SceneBuilder builder{si};
  std::array<Body, 2> bodies{a, b};
  const char* name = "a";
  for (Body& body : bodies) {
    body.name = name, name = "b";
    if (body.mobility != Mobility::fixed) body.mass = 1.0;
    if (body.mobility == Mobility::free) body.inertia = 1.0;
  }
  const BodyId first = builder.add(bodies[0]), second = builder.add(bodies[1]);
  builder.add_contact("touch", first, second, LinearSpringDashpot{1e4, 10.0});
  Pair pair{.model = builder.build()};
  Probe probe{pair.model};
  const State at = rest_state(pair.model);
  constexpr double d = 1e-3;
  const auto overlap = [&](std::size_t i, double by_i, std::size_t j, double by_j) {
    State moved = at;
    moved.q[i] += by_i, moved.q[j] += by_j;
    probe.evaluate(moved);
    return probe.overlap(0);
  };
  if (at.q.empty()) pair.bend = std::nan("");
  for (std::size_t i = 0; i < at.q.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      keep_worst(pair.bend, overlap(i, d, j, d) - overlap(i, d, j, -d) - overlap(i, -d, j, d) + overlap(i, -d, j, -d));
  }
  return pair;
}

/// Checks that the pairs of bodies with a closed form while they touch are those whose overlap is linear in all their
/// coordinates.
void check_linear_overlaps(Findings& findings) {
  const Mobility mobilities[] = {Mobility::free, Mobility::particle, Mobility::fixed, Mobility::sliding_x,
                                 Mobility::sliding_y};
  // Beside each other, above each other, and oblique, on a plane and on a square.
  struct PairPosition {
    Shape a, b;
    Vec2 at;
  };
  const Circle disc{1.0};
  const Rectangle square{1.0, 1.0};
  const PairPosition pairs[] = {{disc, disc, {1.9, 0.0}},           {disc, disc, {0.0, -1.9}},
                                {disc, disc, {1.2, 1.45}},          {disc, HalfPlane{}, {0.2, 0.95}},
                                {square, HalfPlane{}, {0.2, 0.95}}, {disc, square, {0.1, 1.95}},
                                {disc, square, {0.0, 1.95}}};
  double wrong = 0.0, left_out = 0.0, accepted = 0.0;
  for (const PairPosition& position : pairs) {
    for (const Mobility of_a : mobilities) {
      for (const Mobility of_b : mobilities) {
        if (of_a == Mobility::fixed && of_b == Mobility::fixed) continue;
        if (std::holds_alternative<HalfPlane>(position.b) && of_b != Mobility::fixed) continue;
        const Body a{.mobility = of_a, .shape = position.a, .p_WB = position.at},
            b{.mobility = of_b, .shape = position.b};
        for (const Pair& pair : {touching(a, b), touching(b, a)}) {
          const bool has_form = !obstacle_to_closed_form(pair.model), linear = std::abs(pair.bend) < 1e-12;
          accepted += has_form ? 1.0 : 0.0;
          wrong += has_form && !linear ? 1.0 : 0.0;
          // A disc on a side of a square has a closed form, but the solver does not detect it.
          left_out += !has_form && linear && !std::holds_alternative<Rectangle>(position.b) ? 1.0 : 0.0;
        }
      }
    }
  }
  const auto group = findings.in("linear_overlaps");
  findings.expect_exact("pairs classified as linear whose overlap is nonlinear", wrong, 0.0,
                        "second differences over 1e-3 are 5e-7 for nonlinear overlaps and 1e-15 for linear ones");
  findings.expect_exact("pairs of discs and planes with linear overlap, not classified as linear", left_out, 0.0,
                        "as for the previous check");
  findings.expect_exact("pairs classified as linear", accepted, 26.0,
                        "in either order: on a plane 4 kinds of discs and 3 of squares; for two discs on a line along "
                        "which both slide or one is fixed, 3 each; none for a disc on a square");
}

void run(Findings& findings, const Setup& setup) {
  if (!setup.coarse) check_linear_overlaps(findings);
  Table table{.name = "pieces",
              .caption =
                  "Force evaluations and largest errors of the exact propagator, and the evaluations of "
                  "`stormer_cowell` at 1e-9 for comparison.",
              .columns = {"scenes", "segments of the reference", "evaluations", "error", "stormer_cowell"}};
  check_bounce(findings, setup, table);
  check_impacts(findings, setup, table);
  check_latching(findings, setup, table);
  check_rows(findings, setup, table);
  findings.table(table);
}

}  // namespace

Case definition() {
  return {
      .id = "exact_segments",
      .title = "Exact solution between events",
      .family = "speed and accuracy",
      .requirements = {{"integrator.exact",
                        {"rest_evaluations", "rest/permitted", "rest_position", "rest/velocity", "rest/one_output",
                         "impacts: force evaluations in total", "exit_speed", "dashpot_work", "latching_exit",
                         "latching_position", "three_discs", "linear_overlaps"}}},
      .main_checks = {"rest_evaluations", "rest_position", "exit_speed", "latching_exit", "three_discs"},
      .source = "Alefeld et al. 1995; Abramowitz & Stegun 1964",
      .faults = {{"odeint_for_exact", "Fehlberg 7(8) with step control instead of the propagator", "three_discs"},
                 {"stiffness_by_1e-9", "a stiffness with a relative error of 1e-9", "rest_position"},
                 {"other_end_rule", "a contact that is attractive before it ends", "rest_evaluations"},
                 {"dashpot_by_1e-9", "a dashpot with a relative error of 1e-9", "exit_speed"},
                 {"growth_lost", "a latching spring that does not stiffen with the largest force", "latching_exit"}},
      .run = run};
}

}  // namespace talus::verification::problems::exact_segments
