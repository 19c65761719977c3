#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/scenes/cable_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::slack_taut_slack {
namespace {

reference::ImpactEvents exact_snatch(double xi) {
  return reference::impact_events({1.0, 2.0 * xi, 1.0, 1.0}, reference::EndRule::clamped);
}

struct Snatch {
  double tension{};  ///< largest at the steps
  bool slack{};      ///< at the end, with the mass moving back
};

/// Runs a throw whose cable becomes taut the fraction `phase` of a step after the start.
Snatch snatched(double xi, double step, double phase, const Setup& setup, Findings& findings) {
  const double used = setup.has("dashpot_stronger") ? 1.05 * xi : xi;
  const double stiffness = setup.has("cable_softer") ? 0.999 : 1.0;
  const Scene scene = thrown_mass(TensionOnly{stiffness, 2.0 * used}, 1.0, 1.0);
  State state = scene.initial;
  state.q[0] -= phase * step;
  const Integrator method = make_integrator(setup.has("rk4") ? "rk4" : "velocity_verlet");
  const CableRunResult run = run_cables(scene, state, method, {step, 20.0, true, true}, findings);
  return {*std::max_element(run.tension.begin(), run.tension.end()), run.tension.back() == 0.0 && run.end.v[0] < 0.0};
}

/// The undamped error derived on the page, over (w h)^2.
double phase_error(double step, double phase) {
  const double late = 1.0 - phase;
  const double top = phase + 0.5 * std::numbers::pi / step;
  const double nearest = top - std::round(top);
  return 0.125 - 0.5 * late * (1.0 - late) - 0.5 * nearest * nearest;
}

/// Predicted root mean square of the relative error over all phases.
double predicted_rms(double xi, double step) {
  if (xi == 0.0) return step * step / std::sqrt(360.0);
  const double small = 1e-5;
  const double slope =
      std::log(exact_snatch(xi + small).largest_force / exact_snatch(xi - small).largest_force) / (2.0 * small);
  return step * std::hypot(0.5 * xi * (xi * slope - 1.0), 2.0 * xi / std::sqrt(12.0));
}

struct Snatches {
  PhaseError error;
  double step{};  ///< mean
  bool slack{true};
};

Snatches snatches(double xi, double steps, const Setup& setup, Findings& findings) {
  const reference::ImpactEvents exact = exact_snatch(xi);
  Snatches all;
  for (const auto& [i, step, phase] : offset_phases(exact.contact_time, steps)) {
    const Snatch found = snatched(xi, step, phase, setup, findings);
    all.error.add(found.tension / exact.largest_force - 1.0);
    all.step += step / static_cast<double>(fewest_phases);
    all.slack = all.slack && found.slack;
  }
  return all;
}

void check_undamped(Findings& findings, const Setup& setup) {
  const double step = incommensurate_step(std::numbers::pi, 50.0);
  Series points{"velocity Verlet", {}, {}, Style::points}, line{"predicted", {}, {}, Style::points};
  double farthest = 0.0, largest = 0.0;
  for (const double phase : even_phases(fewest_phases)) {
    const double error = (snatched(0.0, step, phase, setup, findings).tension - 1.0) / (step * step);
    const double predicted = phase_error(step, phase);
    points.add(phase, error);
    line.add(phase, predicted);
    keep_worst(farthest, std::abs(error - predicted));
    keep_worst(largest, std::abs(error));
  }
  findings.expect_model(
      {"tension_deviation",
       "peak tension, undamped: largest deviation of the error from its prediction, in units of (w h)^2"},
      farthest, 0.0, step * step, "the next order in h: (w h)^2 of an error of at most (w h)^2/8");
  findings.expect_between(
      {"tension_error", "peak tension, undamped: largest error of 64 phases, in units of (w h)^2"}, largest, 0.1, 0.125,
      "at most 1/8, reached if onset and peak both coincide with a step or both lie half-way between steps");
  findings.figure({.name = "phases",
                   .title = "Error of the peak tension against the onset phase",
                   .caption = "Undamped, 50.4 steps while taut: measured and predicted error for each of 64 phases.",
                   .x = {.label = "onset time / step"},
                   .y = {.label = "error / (T (w h)^2)"},
                   .series = {points, {"predicted", line.x, line.y, Style::crosses}},
                   .lines = {{'y', 0.125, "1/8"}, {'y', -0.125, "-1/8"}}});
}

void check_orders(Findings& findings, const Setup& setup) {
  Figure figure{.name = "error",
                .title = "Error of the peak tension against the step",
                .caption = "Root mean square over 64 phases. Lines: predicted.",
                .x = {.label = "step / duration of the taut phase", .log = true},
                .y = {.label = "relative error", .log = true}};
  bool slack = true;
  for (const double xi : {0.0, 0.1, 0.3}) {
    if (setup.coarse && xi != 0.3) continue;
    const std::string name = xi == 0.0 ? std::string{"undamped"} : fmt::format("xi = {:g}", xi);
    PredictedErrors errors;
    for (const double n : doublings(setup.coarse ? 128.0 : 16.0, setup.coarse ? 1 : 4)) {
      const Snatches all = snatches(xi, n, setup, findings);
      errors.add(1.0 / n, all.error.rms(), predicted_rms(xi, all.step));
      slack = slack && all.slack;
    }
    findings.expect({"tension", "peak tension, rms error at the smallest step over its prediction, " + name},
                    errors.last_ratio(), 1.0,
                    xi == 0.0 ? Tolerance::model(0.05,
                                                 "the prediction assumes uniformly distributed, independent phases of "
                                                 "onset and peak; 64 pairs of phases leave a few percent")
                              : Tolerance::model(0.02, "the next order in h, w h = 0.024"));
    if (!setup.coarse)
      findings.expect_order(
          {"order_of_tension", "order of the peak tension, " + name}, errors.found(), xi == 0.0 ? 1.9 : 0.9,
          xi == 0.0 ? 2.1 : 1.1,
          xi == 0.0 ? "the slope of the tension jumps when the cable becomes taut: h^2"
                    : "the tension jumps when the cable becomes taut, and the dashpot lags by half a step: h");
    figure.series.push_back(errors.points(name));
    figure.series.push_back(errors.line(name + ", predicted"));
  }
  findings.expect_true({"slack_at_end", "slack cable and mass moving back at the end of every throw"}, slack,
                       "the mode of the cable follows its state at every phase");
  if (!setup.coarse) findings.figure(figure);
}

void run(Findings& findings, const Setup& setup) {
  check_undamped(findings, setup);
  check_orders(findings, setup);
}

}  // namespace

Case definition() {
  const std::string phases = "tension_deviation";
  const std::string damped = "peak tension, rms error at the smallest step over its prediction, xi = 0.3";
  return {
      .id = "slack_taut_slack",
      .title = "Cable becoming taut and slack again: peak tension",
      .requirements = {{"D8", {"tension_deviation", "tension_error", "tension", "order_of_tension", "slack_at_end"}},
                       {"Eq. 14", {"tension_deviation", "tension_error"}},
                       {"law.tension_only",
                        {"tension_deviation", "tension_error", "tension", "order_of_tension", "slack_at_end"}},
                       {"integrator.velocity_verlet", {"order_of_tension"}}},
      .main_checks = {phases, damped},
      .source = "Mustoe & Huttelmaier 1993, Eq. 14",
      .faults = {{"cable_softer", "cable softer by 0.1 %", phases},
                 {"rk4", "RK4 instead of velocity Verlet", phases},
                 {"dashpot_stronger", "dashpot coefficient 5 % too large", damped}},
      .run = run};
}

}  // namespace talus::verification::problems::slack_taut_slack
