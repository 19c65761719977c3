#include "verification/reference/cables/mid_span.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::transverse_oscillator {
namespace {

constexpr reference::MidSpan span{1.0, 1.0, 1.0};

Scene mid_span(double w, double load, const Setup& setup) {
  SceneBuilder builder;
  const BodyId mass =
      builder.add(Body{.name = "mass", .mobility = Mobility::sliding_y, .mass = span.mass, .force = {0.0, load}});
  const double tight = setup.has("trace_of_tension") ? 1e-6 : setup.has("trace_of_slack") ? -1e-6 : 0.0;
  for (const double side : {-1.0, 1.0}) {
    const bool softer = side > 0.0 && setup.has("one_cable_softer");
    builder.add_cable(side > 0.0 ? "right" : "left", {.body = {}, .p = {side * span.length, 0.0, 0.0}}, {mass, {}},
                      (1.0 - tight) * span.length, TensionOnly{(softer ? 0.999 : 1.0) * span.stiffness});
  }
  Scene scene = builder.at_rest("Mass at mid-span");
  scene.initial.q[0] = w;
  return scene;
}

double period(double amplitude, double steps, const Setup& setup) {
  const double exact = reference::cubic_period(span, amplitude);
  return period_of(mid_span(amplitude, 0.0, setup), make_integrator(setup.has("rk4") ? "rk4" : "velocity_verlet"),
                   exact / steps, 2.0 * exact * (1.0 + amplitude));
}

void check_steps(Findings& findings, const Setup& setup) {
  constexpr double amplitude = 0.02;
  const double exact = reference::mid_span_period(span, amplitude);
  const PredictedErrors errors = predicted_errors(doublings(80.0, setup.coarse ? 2 : 4), [&](double n) {
    const double steps = n + 0.381966;
    return std::array{1.0 / steps, std::abs(period(amplitude, steps, setup) / exact - 1.0),
                      -reference::longer_by_steps(span, amplitude, exact / steps)};
  });
  findings.expect_order(
      {"order_of_period", "order of the period in the step"}, errors.found(), 1.99, 2.01,
      "smooth motion: even powers of the step only; at 80 steps the fourth order is a few thousandths of the second");
  findings.expect_model(
      {"period_at_smallest", "period, error at the smallest step over its prediction"}, errors.last_ratio(), 1.0,
      setup.coarse ? 0.01 : 1e-3,
      "the prediction is for the cubic oscillator, without terms of (A/L)^2 = 4e-4 and the next power of the step");
  findings.figure({.name = "steps",
                   .title = "Error of the period against the step",
                   .caption = "Amplitude 0.02 L, relative to the exact period at this amplitude.",
                   .x = {.label = "step / period", .log = true},
                   .y = {.label = "relative error of the period", .log = true},
                   .series = {errors.points("velocity Verlet"), errors.line()}});
}

void check_amplitudes(Findings& findings, const Setup& setup) {
  Convergence longer;
  Series points{"velocity Verlet", {}, {}, Style::points}, exact{"exact", {}, {}, Style::lines},
      cubic{"cubic", {}, {}, Style::lines};
  for (const double amplitude : {0.02, 0.04, 0.08, 0.16, 0.4, 1.0, 2.5}) {
    if (amplitude > (setup.coarse ? 0.05 : 3.0)) break;
    const double found = period(amplitude, 2000.381966, setup);
    points.add(amplitude, found);
    if (amplitude < 0.2) longer.add(amplitude, found / reference::cubic_period(span, amplitude) - 1.0);
  }
  findings.expect({"cubic_period", "period at A = 0.02 L against the cubic oscillator"}, points.y.front(),
                  reference::cubic_period(span, 0.02),
                  Tolerance::model(1.5e-4, "the finite amplitude: 0.296 (A/L)^2 = 1.2e-4").relative());
  findings.expect_model(
      {"lengthening", "lengthening of the period at A = 0.02 L over its prediction"},
      longer.errors().front() / reference::longer_by_amplitude(span, 0.02), 1.0, 4e-3,
      "2000 steps shorten the period by 0.85/2000^2, 0.0018 of its lengthening; the next power of (A/L)^2 = 4e-4");
  if (setup.coarse) return;
  findings.expect_order("order of the lengthening in the amplitude", longer, 1.99, 2.01,
                        "even in A; at A = 0.16 L the next power contributes less than 1 %");
  for (double a = 0.02; a < 2.6; a *= 1.3) {
    exact.add(a, reference::mid_span_period(span, a));
    cubic.add(a, reference::cubic_period(span, a));
  }
  findings.figure({.name = "period",
                   .title = "Period against amplitude",
                   .caption = "The cubic oscillator is the limit of small amplitudes; at large amplitudes the period "
                              "tends to $2\\pi\\sqrt{m/2k}$.",
                   .x = {.label = "A / L", .log = true},
                   .y = {.label = "T / sqrt(m/k)", .log = true},
                   .series = {exact, cubic, points},
                   .lines = {{'y', 2.0 * std::numbers::pi / std::sqrt(2.0), "2 pi sqrt(m/2k)"}}});
}

/// A mass under the load P(w), released at rest at w, must remain there.
void check_balance(Findings& findings, const Setup& setup) {
  double largest = 0.0;
  for (const double w : {0.01, -0.1, 0.5, -1.0, 3.0}) {
    const double stretch = std::hypot(1.0, w) - 1.0;
    constexpr long steps = 1000;
    long seen = 0;
    double away = 0.0;
    const Watcher watch = [&](const State& state, const StepInfo&) {
      ++seen;
      const double now = std::abs(state.q[0] / w - 1.0);
      keep_worst(away, now);
    };
    run_steps(mid_span(w, reference::mid_span_force(span, w), setup), make_integrator("velocity_verlet"),
              0.05 / std::abs(w), steps, findings, watch);
    if (seen != steps + 1) away = std::nan("");
    const double fraction = away * stretch / (1.0 + stretch);
    keep_worst(largest, fraction);
  }
  findings.expect_round_off(
      {"static_equilibrium",
       "equilibrium at w under the load P(w), largest displacement as a relative error of the cable length"},
      largest, 0.0, 6e-16,
      "the cable length is rounded by 1.1e-16 of itself, which changes the tension by this error over the relative "
      "elongation; three more roundings at large displacements; the mass oscillates about the displaced equilibrium");
}

void run(Findings& findings, const Setup& setup) {
  check_steps(findings, setup);
  check_amplitudes(findings, setup);
  check_balance(findings, setup);
}

}  // namespace

Case definition() {
  const std::string steps = "period_at_smallest";
  const std::string limit = "cubic_period";
  const std::string loads = "static_equilibrium";
  return {
      .id = "transverse_oscillator",
      .title = "Transverse oscillator: mass between two untensioned cables",
      .requirements = {{"D5",
                        {"order_of_period", "period_at_smallest", "cubic_period", "lengthening", "static_equilibrium"}},
                       {"Eq. 13", {"static_equilibrium"}},
                       {"Eq. 14", {"cubic_period", "lengthening"}},
                       {"law.tension_only", {"cubic_period", "lengthening", "static_equilibrium"}},
                       {"integrator.velocity_verlet", {"order_of_period"}}},
      .main_checks = {limit, steps, loads},
      .source = "Kovacic & Brennan (eds.), The Duffing Equation, 2011, section 2",
      .faults = {{"trace_of_tension", "cables shorter by 1e-6", steps},
                 {"trace_of_slack", "cables longer by 1e-6", loads},
                 {"one_cable_softer", "one cable softer by 0.1 %", limit},
                 {"rk4", "RK4 instead of velocity Verlet", "order_of_period"}},
      .run = run};
}

}  // namespace talus::verification::problems::transverse_oscillator
