#include "solver/scenes/bouncing_disc.hpp"
#include "verification/reference/impacts/damped_bounce.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/impacts/followed_impact.hpp"
#include "verification/study/impacts/leapfrog_impact_error.hpp"
#include "verification/study/impacts/plane_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::bounces {
namespace {

constexpr double gravity = 1.0, fall_height = 1.0;

/// Contact on which the disc falls.
struct Fall {
  double xi{};  ///< damping ratio
  EndRule rule{};
  double frequency{};  ///< w = sqrt(k/m) [rad/T]
};

/// Label of the contact, for example "xi = 0.1, clamped".
std::string name_of(const Fall& fall) {
  return fmt::format("xi = {:g}, {}", fall.xi, fall.rule == EndRule::attractive ? "attractive" : "clamped");
}

/// Reference motion from a gap, with a speed towards the plane.
reference::DampedBounce exact_fall(const Fall& fall, double gap, double speed) {
  return {fall.frequency, fall.xi, gravity, gap, speed, same(fall.rule)};
}

/// The same motion as a scene of the solver. Planted faults: dashpot_halved, weight_halved, other_end_rule.
Scene falling_disc(const Fall& fall, double gap, double speed, const Setup& setup) {
  const double xi = setup.has("dashpot_halved") ? 0.5 * fall.xi : fall.xi;
  const EndRule other = fall.rule == EndRule::attractive ? EndRule::clamped : EndRule::attractive;
  return scenes::bouncing_disc({.radius = 1.0,
                                .gap = gap,
                                .speed = speed,
                                .gravity = setup.has("weight_halved") ? 0.5 * gravity : gravity,
                                .contact = dashpot_of(xi, fall.frequency * fall.frequency, 1.0,
                                                      setup.has("other_end_rule") ? other : fall.rule)});
}

/// Contact time without weight [T].
double contact_time(const Fall& fall) {
  const reference::Impact impact{fall.frequency * fall.frequency, 2.0 * fall.xi * fall.frequency, 1.0, 1.0};
  return reference::impact_events(impact, same(fall.rule)).contact_time;
}

/// Apex gaps of the first bounces, each from the parabola on which the disc is at the first step without contact force.
/// NaN where the run diverged or the disc remained on the plane.
std::vector<double> apexes(const Scene& scene, double step, int bounces, Findings& findings) {
  std::vector<double> found;
  bool acted = false;
  const double weight = -scene.model.gravity.y;
  const Until done = [&](const State& state) {
    const bool acts = state.mode[0] == UnilateralSpring::acting;
    if (acted && !acts) found.push_back(state.q[1] - 1.0 + 0.5 * state.v[1] * state.v[1] / weight);
    acted = acts;
    return static_cast<int>(found.size()) == bounces;
  };
  if (!run_scene(scene, VelocityVerlet{}, {step, 20.0, 20.0, false}, findings, {}, done).finished) found.clear();
  found.resize(static_cast<std::size_t>(bounces), NAN);
  return found;
}

/// 1 - h1/(e^2 h0) of a bounce from just above the plane, mean over 64 phases.
double mean_drop(const Fall& fall, double steps, Findings& findings, const Setup& setup) {
  const double speed = std::sqrt(2.0 * gravity * fall_height);
  const double e = reference::restitution(fall.xi, same(fall.rule));
  double mean = 0.0;
  for (const Phase& phase : offset_phases(contact_time(fall), steps)) {
    // Start on the fall, the time t before touch at speed v: speed v - g t at the gap v t - g t^2/2.
    const double lead = phase.lead();
    const Scene scene = falling_disc(fall, lead * (speed - 0.5 * gravity * lead), speed - gravity * lead, setup);
    const double h1 = apexes(scene, phase.step, 1, findings).front();
    mean += (1.0 - h1 / (e * e * fall_height)) / static_cast<double>(fewest_phases);
  }
  return mean;
}

/// The same without the effect of the dashpot's lag, which is of first order: extrapolated from 200 and 400 steps.
double measured_drop(const Fall& fall, Findings& findings, const Setup& setup) {
  return 2.0 * mean_drop(fall, 400.0, findings, setup) - mean_drop(fall, 200.0, findings, setup);
}

/// Checks that a bounce with weight approaches that on a rigid plane as the contact stiffness grows.
void check_stiff_limit(Findings& findings, const Setup& setup) {
  constexpr double xi = 0.2;
  const double e = reference::restitution(xi, reference::EndRule::clamped);
  const double speed = std::sqrt(2.0 * gravity * fall_height);
  const double contact_angle = 2.0 * reference::contact_angle(xi);  // w T
  Convergence found;
  Series line{"first order", {}, {}, Style::lines}, exact{"exact", {}, {}, Style::lines};
  double worst = 0.0;
  for (const double w : {20.0, 63.2, 200.0, 632.0}) {
    if (setup.coarse && w < 200.0) continue;
    const Fall fall{xi, EndRule::clamped, w};
    const double drop = measured_drop(fall, findings, setup);
    const double apex = reference::bounces(exact_fall(fall, fall_height, 0.0), 1).front().apex_gap;
    const double truth = 1.0 - apex / (e * e * fall_height);
    found.add(w * w, drop);
    const double difference = drop - truth;
    keep_worst(worst, difference);
    line.add(w * w, 4.0 * xi * (1.0 + e) / e * gravity / (w * speed));
    exact.add(w * w, truth);
  }
  findings.expect_truncation(
      {"deficit", "deficit 1 - h1/(e^2 h0), mean of 64 phases, largest error of four stiffnesses"}, worst, 0.0,
      0.17 * std::pow(contact_angle / 400.0, 2), 1.5,
      "the dashpot's lag is extrapolated away, and the mean of the force jump vanishes over evenly spread phases of "
      "touch; the remaining error is of second order, measured, the same at every stiffness");
  findings.expect_order(
      {"order_to_rigid", "order of convergence to the rigid limit in the stiffness"}, found, -0.515, -0.485,
      "G decreases with the square root of the stiffness; G^2, 0.035 G at the lowest stiffness, bends the line");
  findings.expect_model({"deficit_stiffest", "deficit 1 - h1/(e^2 h0) over its first-order term, highest stiffness"},
                        found.errors().back() / line.y.back(), 1.0, 0.02,
                        "the next power of G, 0.001, and the error of the deficit, 8e-6 of 0.0025");
  findings.figure({.name = "stiff_limit",
                   .title = "Convergence to the rigid limit",
                   .caption = "Deficit of the first height from $e^2 h_0$ against the stiffness, $\\xi = 0.2$.",
                   .x = {.label = "stiffness", .log = true},
                   .y = {.label = "1 - h1/(e^2 h0)", .log = true},
                   .series = {{"solver", found.steps(), found.errors(), Style::points}, exact, line},
                   .slopes = {{-0.5, 4e4, 3e-3, "k^(-1/2)"}}});
}

constexpr double frequency = 25.0, production_steps = 50.0;
constexpr int count = 5;     // bounces per run
constexpr int compared = 3;  // of these compared with errors of impacts without weight; later ones are too slow

/// Start of a run on the parabola of the fall, so that the first touch is the fraction `phase` of a step after a step.
struct Onset {
  double gap{}, speed{};
  double passed{};  ///< time since the apex [T]
};
Onset onset(double step, double phase) {
  const double fall = std::sqrt(2.0 * fall_height / gravity);
  const double passed = step * fraction(fall / step - phase);
  return {fall_height - 0.5 * gravity * passed * passed, gravity * passed, passed};
}

/// Predicted relative errors of the heights of an undamped run, bounce by bounce: a disc that leaves faster returns
/// later, at another fraction of a step.
std::vector<double> undamped_errors(const Fall& fall, const Onset& from, double step,
                                    const std::vector<reference::Bounce>& exact) {
  const double wh = fall.frequency * step;
  const double contact = (exact[0].end_time - exact[0].start_time) * (1.0 - wh * wh / 24.0);
  const auto curve = [step](double t) { return fraction(t / step) * (1.0 - fraction(t / step)); };
  std::vector<double> errors;
  double touch = exact[0].start_time - from.passed, ratio = 1.0;
  for (int n = 0; n < count; ++n) {
    const double end = touch + contact;
    ratio *= 1.0 + 0.5 * wh * wh * (curve(end) - curve(touch));
    touch = end + 2.0 * exact[0].start_speed * ratio / gravity;
    errors.push_back(ratio * ratio - 1.0);
  }
  return errors;
}

/// Height errors over 64 runs: measured, and predicted without damping.
struct HeightErrors {
  std::vector<PhaseError> found = std::vector<PhaseError>(count), undamped = std::vector<PhaseError>(count);
};

HeightErrors height_errors(const Fall& fall, double steps, int bounces, Findings& findings, const Setup& setup) {
  const auto exact = reference::bounces(exact_fall(fall, fall_height, 0.0), count);
  HeightErrors errors;
  for (const Phase& phase : offset_phases(contact_time(fall), steps)) {
    const double step = setup.has("large_steps") ? contact_time(fall) / 4.3 : phase.step;
    const Onset from = onset(step, phase.onset);
    const auto found = apexes(falling_disc(fall, from.gap, from.speed, setup), step, bounces, findings);
    const auto undamped = undamped_errors(fall, from, step, exact);
    for (std::size_t n = 0; n < found.size(); ++n) {
      errors.found[n].add(found[n] / exact[n].apex_gap - 1.0);
      errors.undamped[n].add(undamped[n]);
    }
  }
  return errors;
}

double predicted_rms(const Fall& fall, int bounce, double steps, const HeightErrors& errors) {
  const double undamped = fall.xi > 0.0 ? 0.0 : errors.undamped[static_cast<std::size_t>(bounce - 1)].rms();
  if (fall.xi == 0.0) return undamped;
  const double wh = fall.frequency * contact_time(fall) / (steps + 0.5);
  const double both = leapfrog_impact_error(fall.xi, same(fall.rule)).restitution;
  const double shift = leapfrog_restitution_shift(fall.xi, same(fall.rule));
  const double jump = std::sqrt((both - shift) * (both + shift));
  return std::hypot(2.0 * wh * bounce * shift, 2.0 * wh * jump * std::sqrt(bounce));
}

constexpr Fall falls[] = {{0.0, EndRule::attractive, frequency},
                          {0.05, EndRule::attractive, frequency},
                          {0.1, EndRule::attractive, frequency},
                          {0.1, EndRule::clamped, frequency}};

void check_heights(Findings& findings, const Setup& setup) {
  Table table{.name = "heights",
              .caption =
                  "Apex gaps, exact and in the rigid limit $e^{2k}$, and the solver's relative errors at 50 steps per "
                  "contact (root mean square over 64 runs), measured and predicted.",
              .columns = {"contact", "bounce", "exact", "rigid", "error", "predicted"}};
  for (const Fall& fall : falls) {
    if (setup.coarse && fall.xi < 0.1) continue;
    const auto exact = reference::bounces(exact_fall(fall, fall_height, 0.0), count);
    const auto errors = height_errors(fall, production_steps, setup.coarse ? compared : count, findings, setup);
    const double e = reference::restitution(fall.xi, same(fall.rule));
    double worst = 1.0;
    for (int n = 1; n <= (fall.xi == 0.0 ? count : setup.coarse ? compared : count); ++n) {
      const auto at = static_cast<std::size_t>(n - 1);
      const double predicted = predicted_rms(fall, n, production_steps, errors);
      if (fall.xi == 0.0 || n <= compared) worst = worst_ratio(worst, errors.found[at].rms() / predicted);
      if (n == 1 || n == count)
        table.rows.push_back(cells("{} | {} | {:.6f} | {:.6f} | {:.2e} | {:.2e}", name_of(fall), n, exact[at].apex_gap,
                                   fall_height * std::pow(e, 2 * n), errors.found[at].rms(), predicted));
    }
    const Tolerance near =
        fall.xi == 0.0 ? Tolerance::model(0.1,
                                          "predicted bounce by bounce; the prediction omits the weight during contact, "
                                          "G = 0.03, and the next power of the step, 0.06")
                       : Tolerance::model(0.15,
                                          "64 random phases at each later bounce determine a root mean square to 9 %; "
                                          "the weight and the next power of the step add some hundredths");
    findings.expect({"heights", "rms error of the heights over the predicted, worst bounce, " + name_of(fall)}, worst,
                    1.0, near);
  }
  findings.table(table);
}

void check_orders(Findings& findings, const Setup& setup) {
  Figure figure{.name = "error_of_heights",
                .title = "Error of the heights against the step",
                .caption = "Root mean square over 64 runs. Lines: predicted from the errors of single impacts.",
                .x = {.label = "step / contact time", .log = true},
                .y = {.label = "relative error", .log = true}};
  const auto study = [&](const Fall& fall, int bounce, const std::string& name) {
    const PredictedErrors all = predicted_errors(doublings(16.0, 3), [&](double n) {
      const HeightErrors errors = height_errors(fall, n, bounce, findings, setup);
      return std::array{1.0 / n, errors.found[static_cast<std::size_t>(bounce - 1)].rms(),
                        predicted_rms(fall, bounce, n, errors)};
    });
    figure.series.push_back(all.points(name));
    figure.series.push_back(all.line(name + ", predicted"));
    return all.found();
  };
  findings.expect_order("order of the error of the first height, undamped", study(falls[0], 1, "h1, undamped"), 1.85,
                        2.15, "the force has a kink at touch and end; the 64 uneven phases of the end tilt the line");
  findings.expect_order("order of the error of the fifth height, " + name_of(falls[2]),
                        study(falls[2], count, "h5, " + name_of(falls[2])), 0.85, 1.15,
                        "the force jumps at touch and end; 64 random phases determine each root mean square to 9 %, "
                        "which tilts a line over two octaves by up to 0.1");
  findings.figure(figure);
}

/// Checks the number of contacts until the disc remains on the plane, and its overlap at rest.
void check_rest(Findings& findings, const Setup& setup) {
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    const Fall fall{0.3, rule, frequency};
    const auto exact = reference::bounces(exact_fall(fall, fall_height, 0.0), 100);
    int contacts = 0;
    bool acted = false;
    const Until count_contacts = [&](const State& state) {
      const bool acts = state.mode[0] == UnilateralSpring::acting;
      if (acts && !acted) ++contacts;
      acted = acts;
      return false;
    };
    const double end = exact.back().start_time + 40.0 / (fall.xi * fall.frequency);
    const RunEnd run = run_scene(falling_disc(fall, fall_height, 0.0, setup), VelocityVerlet{}, {1e-3, end, end, false},
                                 findings, {}, count_contacts);
    const char* word = rule == EndRule::attractive ? "attractive" : "clamped";
    findings.expect_exact(
        {"contacts_to_rest", fmt::format("number of contacts until the disc remains on the plane, xi = 0.3, {}", word)},
        run.finished ? static_cast<double>(contacts) : NAN, static_cast<double>(exact.size()),
        "a count; the last rebound is not marginal");
    findings.expect_round_off({"overlap_at_rest", fmt::format("overlap at rest, xi = 0.3, {}", word)},
                              1.0 - run.state.q[1], exact.back().end_depth, 2.3e-16,
                              "the height of 1 is rounded to 1.1e-16, and so is its final value");
  }
}

void show_bounces(Findings& findings, const Setup& setup) {
  const Fall fall{0.1, EndRule::clamped, 12.0};
  Series solver{"solver", {}, {}, Style::points}, exact{"exact", {}, {}, Style::lines};
  run_steps(falling_disc(fall, fall_height, 0.0, setup), VelocityVerlet{}, 0.0025, 3600, nullptr,
            [&](const State& state, const StepInfo& info) {
              if (info.step % 40 == 0) solver.add(state.t, state.q[1] - 1.0);
            });
  for (double t = 0.0; t < 9.0; t += 0.02)
    exact.x.push_back(t);
  for (const auto& at : reference::bounce_states(exact_fall(fall, fall_height, 0.0), exact.x))
    exact.y.push_back(at.gap);
  findings.figure({.name = "bounces",
                   .title = "A disc on a soft plane",
                   .caption = "Gap against time with a contact so soft that its overlap is visible, $\\omega = 12$, "
                              "$\\xi = 0.1$, clamped.",
                   .x = {.label = "time"},
                   .y = {.label = "gap"},
                   .series = {exact, solver}});
}

void run(Findings& findings, const Setup& setup) {
  check_heights(findings, setup);
  if (!setup.coarse) check_orders(findings, setup);
  check_stiff_limit(findings, setup);
  if (setup.coarse) return;
  check_rest(findings, setup);
  show_bounces(findings, setup);
}

}  // namespace

Case definition() {
  const std::string heights = "rms error of the heights over the predicted, worst bounce, ";
  return {.id = "bounces",
          .title = "Bouncing disc under gravity",
          .requirements = {{"B6",
                            {"heights", "order of the error of the first height, undamped",
                             "order of the error of the fifth height, xi = 0.1, attractive", "order_to_rigid",
                             "contacts_to_rest", "overlap_at_rest"}},
                           {"B7", {"deficit", "order_to_rigid", "deficit_stiffest"}},
                           {"law.linear_spring_dashpot", {"heights"}},
                           {"end_rule.attractive",
                            {"rms error of the heights over the predicted, worst bounce, xi = 0.1, attractive"}},
                           {"end_rule.clamped",
                            {"rms error of the heights over the predicted, worst bounce, xi = 0.1, clamped"}},
                           {"integrator.velocity_verlet, pair.circle.half_plane", {"heights"}}},
          .main_checks = {heights + name_of(falls[0]), heights + name_of(falls[2]), heights + name_of(falls[3]),
                          "order_to_rigid"},
          .source = "Mustoe & Huttelmaier 1993, Eq. 17; Bartz 2022, arXiv 2204.10917",
          .faults = {{"dashpot_halved", "the dashpot is halved", heights + name_of(falls[2])},
                     {"other_end_rule", "the contact has the other end rule", heights + name_of(falls[3])},
                     {"large_steps", "four steps per contact", heights + name_of(falls[3])},
                     {"weight_halved", "the weight is halved", "deficit_stiffest"}},
          .run = run};
}

}  // namespace talus::verification::problems::bounces
