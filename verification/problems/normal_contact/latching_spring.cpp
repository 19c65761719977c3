#include "solver/scenes/bouncing_disc.hpp"
#include "verification/reference/impacts/latching_impact.hpp"
#include "verification/study/impacts/plane_impact.hpp"
#include "verification/study/impacts/pressed_disc.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::latching_spring {
namespace {

/// Checks forces and work of a disc pressed along a prescribed path against straight lines, to the last bit. The path
/// reloads inside the hysteresis loop, from the slack state and after separation.
void check_latching_path(Findings& findings, const Setup& setup) {
  PressedDisc disc{setup.has("forgets_at_zero_force")};
  const char* exact = "all overlaps, forces and their products are short sums of powers of two, without rounding";
  disc.press(0.5);
  disc.press(0.4375);
  const double before = disc.work();
  disc.press(0.46875);
  disc.press(0.4375);
  findings.expect_exact("work of a loop on the unloading line", disc.work() - before, 0.0, exact, "J");
  for (const double turn : {0.125, 0.453125, 0.625, 0.015625, 0.5, -0.015625})
    disc.press(turn);
  // The work depends only on the largest overlap M = 5/8, not on the turning points: K1 M^2/2 (1 - K1/K2).
  findings.expect_exact("work of the whole path until the surfaces separate", disc.work(), 0.5 * 64.0 * 0.390625 * 0.75,
                        exact, "J");
  disc.press(0.25);
  const std::vector<double> lines = reference::latching_forces({64.0, 256.0, 0.0, 1.0, 1.0}, disc.path());
  double largest = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    keep_largest(largest, disc.forces()[i] - lines[i]);
  findings.expect_exact({"path", "force along a prescribed path, largest difference"}, largest, 0.0, exact, "N");
  if (setup.coarse) return;
  Series solver{"solver", {}, {}, Style::points};
  for (std::size_t i = 0; i < lines.size(); i += 24)
    solver.add(disc.path()[i], disc.forces()[i]);
  findings.figure({.name = "path",
                   .title = "Force along a prescribed path",
                   .caption =
                       "Successive overlaps: 1/2, 7/16, 15/32, 7/16, 1/8, 29/64, 5/8, 1/64, 1/2, separated, 1/4. After "
                       "slack, reloading follows the stiff line; after separation, the soft line from zero.",
                   .x = {.label = "overlap", .unit = "m"},
                   .y = {.label = "force", .unit = "N"},
                   .series = {{"reference", disc.path(), lines, Style::lines}, solver}});
}

constexpr double production_steps = 100.0;

double gamma(double phase) { return phase * (1.0 - phase); }

/// An impact: speed of approach, the law given to the solver, and the exact events.
struct Latch {
  double speed{};
  LatchingSpring law;
  reference::LatchingEvents exact;
};

Latch latch(double e, const Setup& setup) {
  const double back = 1.0 / (e * e);
  return {1.0,
          {1.0, setup.has("ratio_for_root") ? 1.0 / e : back, 0.0},
          reference::latching_events({1.0, back, 0.0, 1.0, 1.0})};
}

Latch growing_latch(double speed, const Setup& setup) {
  return {speed,
          {1.0, 1.0, setup.has("growth_halved") ? 0.5 : 1.0},
          reference::latching_events({1.0, 1.0, 1.0, 1.0, speed})};
}

/// Relative errors of one impact, measured or predicted.
struct ImpactError {
  double restitution{}, contact_time{}, largest{}, residual{}, balance_error{};
};

ImpactError predicted_error(const Latch& l, double step, double phase) {
  const double w1 = l.exact.loading_frequency * step, w2 = l.exact.unloading_frequency * step;
  const double r = l.exact.restitution * l.exact.restitution;
  // The leapfrog's period is shorter by the fraction (w h)^2/24: largest overlap and end come early by this time.
  const double loading = l.exact.turn_time, unloading = l.exact.contact_time - loading;
  const double early_turn = loading * w1 * w1 / 24.0, early_end = early_turn + unloading * w2 * w2 / 24.0;
  const double touch = gamma(phase);
  const double turn = gamma(fraction(phase + (loading - early_turn) / step + 0.5));
  const double end = gamma(fraction(phase + (l.exact.contact_time - early_end) / step));
  ImpactError error;
  error.largest = 0.5 * w1 * w1 * (turn - touch);
  error.residual = error.largest;
  error.restitution = 0.5 * w2 * w2 * (end - (1.0 - r) * turn - r * touch);
  if (l.law.growth > 0.0) error.restitution -= 0.5 * (1.0 - r) * error.largest;
  error.contact_time = -w1 * w2 / 24.0;
  error.balance_error = 0.25 * std::numbers::pi * (1.0 - r) * w1;
  return error;
}

ImpactError impact_error(const Latch& l, double step, double phase, Findings& findings, const Setup& setup) {
  const PlaneRebound seen =
      plane_rebound(l.law, {l.speed, 128.0, step, phase, 3.0 * l.exact.contact_time + 4.0 * step}, findings);
  if (!seen.ended()) return {NAN, NAN, NAN, NAN, NAN};
  // The force is linear in the overlap and zero at the residual overlap, which the disc passes in the last step.
  const std::size_t last = seen.depth.size() - 1;
  const auto depth = [&](std::size_t back) { return seen.depth[last - back]; };
  const auto force = [&](std::size_t back) { return seen.force[last - back]; };
  const double residual = depth(1) - force(1) * (depth(2) - depth(1)) / (force(2) - force(1));
  const double end = seen.time[last - 1] + step * (depth(1) - residual) / (depth(1) - depth(0));
  return {seen.speed / (l.exact.restitution * l.speed) - 1.0, end / l.exact.contact_time - 1.0,
          *std::max_element(seen.depth.begin(), seen.depth.end()) / l.exact.largest_depth - 1.0,
          residual / l.exact.residual_depth - 1.0,
          seen.balance_error - (setup.has("loss_not_booked") ? seen.lost : 0.0)};
}

/// Root mean squares over 64 phases.
struct ImpactErrors {
  PhaseError restitution, contact_time, largest, residual, balance_error;
  double mean_restitution{};
  void add(const ImpactError& error) {
    restitution.add(error.restitution);
    contact_time.add(error.contact_time);
    largest.add(error.largest);
    residual.add(error.residual);
    balance_error.add(error.balance_error);
    mean_restitution += error.restitution / static_cast<double>(fewest_phases);
  }
};
struct Comparison {
  ImpactErrors found, predicted;
};

Comparison compare(const Latch& l, double steps, Findings& findings, const Setup& setup) {
  Comparison all;
  for (const auto& [i, step, phase] :
       offset_phases(l.exact.contact_time, steps, fewest_phases, setup.has("commensurate_step"))) {
    all.found.add(impact_error(l, step, phase, findings, setup));
    all.predicted.add(predicted_error(l, step, phase));
  }
  return all;
}

void check_targets(Findings& findings, const Setup& setup) {
  ImpactError ratio{1.0, 1.0, 1.0, 1.0, 1.0};
  Table table{.name = "targets",
              .caption =
                  "Disc on a plane, velocity Verlet, 100 steps per contact: relative errors, root mean square over 64 "
                  "phases, measured and predicted.",
              .columns = {"K1/K2", "e", "error of e", "predicted", "error of T", "predicted", "error of M", "predicted",
                          "energy balance error", "predicted"}};
  for (const double e : {0.9, 0.7, 0.5, 0.3}) {
    const Comparison c = compare(latch(e, setup), production_steps, findings, setup);
    const auto number = [](double x) { return fmt::format("{:.2e}", x); };
    const auto over = [](const PhaseError& found, const PhaseError& predicted) {
      return found.rms() / predicted.rms();
    };
    const ImpactErrors &f = c.found, &p = c.predicted;
    ratio = {worst_ratio(ratio.restitution, over(f.restitution, p.restitution)),
             worst_ratio(ratio.contact_time, over(f.contact_time, p.contact_time)),
             worst_ratio(ratio.largest, over(f.largest, p.largest)),
             worst_ratio(ratio.residual, over(f.residual, p.residual)),
             worst_ratio(ratio.balance_error, over(f.balance_error, p.balance_error))};
    table.rows.push_back(cells("{:.2f} | {:g} | {} | {} | {} | {} | {} | {} | {} | {}", e * e, e,
                               number(f.restitution.rms()), number(p.restitution.rms()), number(f.contact_time.rms()),
                               number(p.contact_time.rms()), number(f.largest.rms()), number(p.largest.rms()),
                               number(f.balance_error.rms()), number(p.balance_error.rms())));
  }
  const auto expect = [&](const std::string& name, double value, double bound, const char* why) {
    findings.expect_model({"impacts/" + name, name + " over the predicted, worst of e = 0.9 ... 0.3"}, value, 1.0,
                          bound, why);
  };
  expect("rms error of e", ratio.restitution, 0.005,
         "predicted impact by impact, at the fractions of a step of the leapfrog's own events; the next order is (w2 "
         "h)^2 of it, 0.0046 for e = 0.3");
  expect("rms error of the contact time", ratio.contact_time, 6e-4,
         "the error is that of the leapfrog's period alone; the next power of the step is 0.11 (w2 h)^2 of it, 5e-4 "
         "for e = 0.3, and the interpolated end, off by up to 1.5 % of it at random, adds the square of that, 1e-4");
  const char* of_overlap = "as for e; the next order is (w1 h)^2 of it, 9e-4 for e = 0.9";
  expect("rms error of the largest overlap", ratio.largest, 1e-3, of_overlap);
  expect("rms error of the residual overlap", ratio.residual, 1e-3, of_overlap);
  expect("energy balance error", ratio.balance_error, 0.015,
         "predicted to first order; the next term of the sum over steps, h^2/12 times the slopes of the recorded power "
         "at touch and at the largest overlap, is up to (4/(3 pi)) w1 h = 0.013 of it");
  findings.table(table);
}

void check_order(Findings& findings, const Setup& setup) {
  const PredictedErrors all = predicted_errors(doublings(16.0, setup.coarse ? 4 : 6), [&](double n) {
    const Comparison c = compare(latch(0.7, setup), n, findings, setup);
    return std::array{1.0 / n, c.found.restitution.rms(), c.predicted.restitution.rms()};
  });
  findings.expect_order({"order_of_e", "order of the error of e = 0.7"}, all.found(), 1.85, 2.15,
                        "the force is continuous and its slope jumps at touch, largest overlap and end, which gives an "
                        "error of h^2; the fractions of a step at touch and largest overlap are correlated, which "
                        "moves points by a third and the line by 0.1");
  findings.figure({.name = "error_of_e",
                   .title = "Error of the restitution against the step",
                   .caption = "$e = 0.7$, root mean square over 64 phases, each with a different step. Line: predicted "
                              "impact by impact, nothing is fitted. It is not straight: touch and largest overlap are "
                              "a quarter period apart, which correlates their fractions of a step.",
                   .x = {.label = "step / contact time", .log = true},
                   .y = {.label = "relative error of e", .log = true},
                   .series = {all.points("solver"), all.line()},
                   .slopes = {{2.0, 1.0 / 64.0, 1e-5, "h^2"}}});
}

void check_growth(Findings& findings, const Setup& setup) {
  double worst = 1.0;
  Series points{"solver, mean of 64 phases", {}, {}, Style::points}, line{"closed form", {}, {}, Style::lines};
  for (const double speed : {0.0625, 0.25, 1.0, 4.0, 16.0}) {
    const Latch l = growing_latch(speed, setup);
    const Comparison c = compare(l, production_steps, findings, setup);
    worst = worst_ratio(worst, c.found.restitution.rms() / c.predicted.restitution.rms());
    points.add(speed, l.exact.restitution * (1.0 + c.found.mean_restitution));
  }
  for (double speed = 0.04; speed < 25.0; speed *= 1.2) {
    line.add(speed, growing_latch(speed, {}).exact.restitution);
  }
  findings.expect_model(
      {"growing_k2", "rms error of e over the predicted, K2 growing with the force, worst of five speeds"}, worst, 1.0,
      0.0065,
      "as for the constant ratio, with the error of the largest overlap in K2; the next order is (w2 h)^2 of it, "
      "0.0065 at the highest speed");
  double given = 0.0, times = 0.0;
  for (const double speed : {0.0625, 0.25, 1.0}) {
    constexpr double e = 0.6;
    LatchingSpring law = growing_latch(speed, {}).law;
    law.set_restitution(e, 1.0, speed);
    const double k2 = law.unloading_stiffness;
    keep_worst(given, reference::latching_events({1.0, k2, law.growth, 1.0, speed}).restitution / e - 1.0);
    // A stiffness and a mass other than 1.
    law.stiffness = 3.0;
    law.set_restitution(e, 2.0, speed);
    const reference::LatchingEvents events =
        reference::latching_events({3.0, law.unloading_stiffness, law.growth, 2.0, speed});
    keep_worst(given, events.restitution / e - 1.0);
    keep_worst(times, law.contact_time(2.0, speed) / events.contact_time - 1.0);
    keep_worst(times, law.largest_overlap(2.0, speed) / events.largest_depth - 1.0);
  }
  findings.expect_round_off(
      "closed-form e of a growing K2 that is set for e = 0.6, three speeds, largest relative error", given, 0.0, 1e-15,
      "K2 = K1/e^2 less its growth, about ten roundings of half that in e");
  findings.expect_round_off("contact time and overlap that the law gives for a growing K2, largest relative error",
                            times, 0.0, 1e-15, "two quarter periods, about ten roundings");
  if (setup.coarse) return;
  findings.figure({.name = "speeds",
                   .title = "Restitution decreases with speed",
                   .caption = "$K_2 = K_1 + S F_{max}$: restitution against speed, in units of $\\omega_1/S$.",
                   .x = {.label = "speed of approach", .log = true},
                   .y = {.label = "restitution", .min = 0.0, .max = 1.0},
                   .series = {line, points}});
}

/// Checks that only the ratio K1/K2 enters e: speeds and lengths multiplied by powers of two change no bit.
void check_speeds(Findings& findings) {
  const auto exit = [&](double scale) {
    const LatchingSpring law{1.0, 2.0, 0.0};
    const Scene scene =
        scenes::bouncing_disc({.radius = 8.0 * scale, .gap = 0.01 * scale, .speed = scale, .contact = ContactLaw{law}});
    return run_scene(scene, VelocityVerlet{}, {0.03, 6.0, 6.0, false}, findings).state.v[1] / scale;
  };
  double change = 0.0;
  for (int j = -8; j <= 8; ++j)
    keep_largest(change, exit(std::ldexp(1.0, j)) - exit(1.0));
  findings.expect_exact("change of e, speeds 2^-8 ... 2^8", change, 0.0,
                        "powers of two change exponents only: every operation rounds alike");
}

/// Checks two discs on one wall, the first in contact while the second still approaches: the largest overlap stored by
/// a contact follows its overlap, independently of other contacts.
void check_pair(Findings& findings) {
  const LatchingSpring law{1e4, 4e4, 0.0};
  SceneBuilder builder{si};
  const BodyId wall = builder.add_fixed("wall", HalfPlane{});
  for (const auto& [name, gap] : {std::pair{"first", 0.01}, std::pair{"second", 1.0}}) {
    const BodyId disc = builder.add_particle(name, 1.0, {gap * 10.0, 0.5 + gap}, Circle{0.5});
    builder.add_contact(fmt::format("hit of the {}", name), disc, wall, law);
  }
  Scene scene = builder.at_rest();
  scene.initial.v[1] = scene.initial.v[3] = -1.0;
  // Between two events the largest overlap stored in an output equals the overlap as long as the overlap grows.
  double behind = 0.0;
  int seen = 0;
  const auto watch = [&](const State& state, const StepInfo&) {
    const double overlap = 0.5 - state.q[1];
    if (overlap <= 0.0 || state.v[1] >= 0.0) return;
    keep_worst(behind, state.z[0] - overlap);
    ++seen;
  };
  const RunEnd end =
      run_scene(scene, make_integrator("stormer_cowell", 1e-10), {5e-4, 2.0, 5e-4, true}, findings, watch);
  double worst = 0.0;
  for (const std::size_t i : {1U, 3U})
    keep_worst(worst, end.state.v[i] - 0.5);
  findings.expect_exact("stored largest overlap of the first disc during loading, minus its overlap",
                        seen > 10 ? behind : std::nan(""), 0.0, "during loading both are the same number", "m");
  findings.expect_truncation(
      "speeds of two discs after successive impacts, sqrt(K1/K2) of the initial ones, largest error", worst, 0.0, 6e-11,
      1.0,
      "a dozen steps per contact, within a tolerance of 1e-10 of the largest speed, a third of it on average: as a "
      "random walk sqrt(12)/3 times, of which the restitution of 0.5 leaves half",
      "m/s");
}

void run(Findings& findings, const Setup& setup) {
  check_targets(findings, setup);
  check_order(findings, setup);
  check_growth(findings, setup);
  check_latching_path(findings, setup);
  if (setup.coarse) return;
  check_speeds(findings);
  check_pair(findings);
}

}  // namespace

Case definition() {
  return {.id = "latching_spring",
          .title = "Latching spring: impacts and unloading",
          .requirements = {{"B11", {"impacts", "order_of_e", "change of e, speeds 2^-8 ... 2^8"}},
                           {"B12", {"growing_k2"}},
                           {"B13",
                            {"work of a loop on the unloading line",
                             "work of the whole path until the surfaces separate", "path"}},
                           {"law.latching_spring",
                            {"impacts/rms error of e", "impacts/rms error of the contact time",
                             "impacts/energy balance error", "growing_k2", "path"}},
                           {"mechanism.contact_damping", {"impacts/energy balance error"}},
                           {"method.resultant",
                            {"impacts/rms error of e", "impacts/rms error of the contact time", "growing_k2", "path"}},
                           {"integrator.velocity_verlet", {"order_of_e"}},
                           {"regime.latching_spring.loading", {"path"}},
                           {"regime.latching_spring.unloading", {"order_of_e", "path"}},
                           {"regime.latching_spring.slack", {"path"}}},
          .main_checks = {"impacts/rms error of e", "order_of_e", "growing_k2", "path"},
          .source = "Walton & Braun, J. Rheology 30 (1986) 949",
          .faults = {{"ratio_for_root", "K1/K2 is set to e instead of its square", "impacts/rms error of e"},
                     {"growth_halved", "the growth of K2 is halved", "growing_k2"},
                     {"forgets_at_zero_force", "the largest overlap is reset where the force is zero", "path"},
                     {"loss_not_booked", "the hysteresis loss is omitted from the energy balance",
                      "impacts/energy balance error"},
                     {"commensurate_step", "the contact time is a multiple of the step", "order_of_e"}},
          .run = run};
}

}  // namespace talus::verification::problems::latching_spring
