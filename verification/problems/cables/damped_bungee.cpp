#include "verification/reference/impacts/damped_bounce.hpp"
#include "verification/study/scenes/cable_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::damped_bungee {
namespace {

constexpr double damping_ratio = 0.2, production_steps = 50.0;

reference::Bounce exact_catch(double frequency, double xi, double gravity, double speed) {
  return reference::bounces({frequency, xi, gravity, 0.0, speed, reference::EndRule::clamped}, 1).front();
}

/// Speed at x = 0 of a mass that leaves the taut cable in this state, under the true weight.
double return_speed(const reference::Bounce& taut, double gravity) {
  return std::sqrt(taut.end_velocity * taut.end_velocity - 2.0 * gravity * taut.end_depth);
}

double exact_restitution(double gravity) {
  return return_speed(exact_catch(1.0, damping_ratio, gravity, 1.0), gravity);
}

/// Predicted root mean square over the phases of the relative error of e, for steps of this length.
double predicted_error(double gravity, double step) {
  const double exact = exact_restitution(gravity), lag = damping_ratio * step, small = 1e-4;
  const auto changed = [&](double fraction, double speed) {
    const double more = 1.0 + 0.5 * fraction;
    return return_speed(exact_catch(more, more * damping_ratio, gravity * more * more, speed), gravity);
  };
  const double shift = (changed(small, 1.0) - changed(-small, 1.0)) / (2.0 * small) * lag;
  const double leap = (changed(0.0, 1.0 + small) - changed(0.0, 1.0 - small)) / (2.0 * small) * 2.0 * lag;
  return std::hypot(shift, leap / std::sqrt(12.0)) / exact;
}

struct Catch {
  double restitution{}, minimum_tension{};
};

Catch caught(double gravity, double step, double phase, const Setup& setup, Findings& findings) {
  const double used = setup.has("weight_left_out") ? 0.0 : gravity;
  const double xi = setup.has("dashpot_stronger") ? 1.02 * damping_ratio : damping_ratio;
  const Scene scene = thrown_mass(TensionOnly{1.0, 2.0 * xi}, 1.0, 1.0 - used * phase * step, used);
  State state = scene.initial;
  state.q[0] -= phase * step * (1.0 - 0.5 * used * phase * step);
  const CableRunResult run = run_cables(scene, state, VelocityVerlet{}, {step, 50.0, true, true}, findings);
  const double back = setup.has("read_where_seen_slack") ? 0.0 : run.end.q[0] - cable_length;
  return {std::sqrt(run.end.v[0] * run.end.v[0] - 2.0 * used * back),
          *std::min_element(run.tension.begin(), run.tension.end())};
}

struct Catches {
  PhaseError error;
  double minimum_tension{};
  double step{};  ///< mean
};

Catches catches(double gravity, double steps, const Setup& setup, Findings& findings) {
  const double exact = exact_restitution(gravity);
  const double taut = exact_catch(1.0, damping_ratio, gravity, 1.0).end_time;
  Catches all;
  for (const auto& [i, step, phase] : offset_phases(taut, steps)) {
    const Catch found = caught(gravity, step, phase, setup, findings);
    all.error.add(found.restitution / exact - 1.0);
    all.minimum_tension = std::min(all.minimum_tension, found.minimum_tension);
    all.step += step / static_cast<double>(fewest_phases);
  }
  return all;
}

void check_speeds(Findings& findings, const Setup& setup) {
  Table table{.name = "restitution",
              .caption =
                  "Ratio $e$ of return speed to initial speed at $x = 0$: exact, to first order in the weight, and the "
                  "solver's relative error at 50 steps (root mean square over 64 phases) with its prediction.",
              .columns = {"G", "exact", "first order", "error", "predicted"}};
  const double without = exact_restitution(0.0);
  double minimum = 0.0;
  for (const double gravity : {0.0, 0.03, 0.1, 0.3}) {
    if (setup.coarse && gravity != 0.1) continue;
    const Catches found = catches(gravity, production_steps, setup, findings);
    const double predicted = predicted_error(gravity, found.step);
    minimum = std::min(minimum, found.minimum_tension);
    findings.expect_model(
        {"restitution", fmt::format("return speed ratio e, rms error over its prediction, G = {:g}", gravity)},
        found.error.rms() / predicted, 1.0, 0.01,
        "the next order in h: w h = 0.055, of which less than a tenth remains in the root mean square over 64 phases");
    table.rows.push_back(cells("{:g} | {:.6f} | {:.6f} | {:.2e} | {:.2e}", gravity, exact_restitution(gravity),
                               without - 2.0 * damping_ratio * (1.0 + without) * gravity, found.error.rms(),
                               predicted));
  }
  findings.expect_exact({"minimum_tension", "minimum tension of all runs"}, minimum, 0.0,
                        "zero after the cable has gone slack");
  findings.table(table);
}

void check_order(Findings& findings, const Setup& setup) {
  constexpr double gravity = 0.1;
  const PredictedErrors errors = predicted_errors(doublings(16.0, 5), [&](double n) {
    const Catches all = catches(gravity, n, setup, findings);
    return std::array{1.0 / n, all.error.rms(), predicted_error(gravity, all.step)};
  });
  findings.expect_order(
      {"order_of_e", "order of the return speed ratio e"}, errors.found(), 0.97, 1.02,
      "the jump of the force and the lag of the dashpot are of first order; the next order in h tilts the fitted line");
  findings.figure({.name = "error",
                   .title = "Error of the return speed",
                   .caption = "G = 0.1, root mean square over 64 phases. Line: predicted from the lag of the dashpot "
                              "and the jump of the force.",
                   .x = {.label = "step / duration of the taut phase", .log = true},
                   .y = {.label = "relative error", .log = true},
                   .series = {errors.points("velocity Verlet"), errors.line()}});
}

void show_weights(Findings& findings, const Setup& setup) {
  const std::vector<double> weights = multiples(0.025, 0, 12);
  const double without = exact_restitution(0.0);
  const auto first_order = [&](double g) { return without - 2.0 * damping_ratio * (1.0 + without) * g; };
  Series found{"velocity Verlet, 800 steps", {}, {}, Style::points};
  for (std::size_t i = 0; i < weights.size(); i += 2)
    found.add(weights[i], caught(weights[i], 0.0035, 0.5, setup, findings).restitution);
  findings.figure(
      {.name = "weight",
       .title = "Effect of the weight on the return speed",
       .caption = "Return speed over $v_0$ at $x = 0$. The formula without weight holds only at $G = 0$.",
       .x = {.label = "G = g/(w v0)"},
       .y = {.label = "e"},
       .series = {curve("exact", weights, exact_restitution), curve("first order in G", weights, first_order), found}});
}

void run(Findings& findings, const Setup& setup) {
  check_speeds(findings, setup);
  if (setup.coarse) return;
  check_order(findings, setup);
  show_weights(findings, setup);
}

}  // namespace

Case definition() {
  const std::string speeds = "return speed ratio e, rms error over its prediction, G = ";
  return {.id = "damped_bungee",
          .title = "Damped bungee: fall into a cable with a dashpot",
          .requirements = {{"D2", {"restitution", "minimum_tension", "order_of_e"}},
                           {"Eq. 14", {"minimum_tension"}},
                           {"law.tension_only", {"restitution", "order_of_e"}},
                           {"integrator.velocity_verlet", {"order_of_e"}}},
          .main_checks = {speeds + "0.03", speeds + "0.1", "order_of_e"},
          .source = "Mustoe & Huttelmaier 1993, Eq. 14",
          .faults = {{"weight_left_out", "gravity omitted", speeds + "0.1"},
                     {"dashpot_stronger", "dashpot coefficient 2 % too large", speeds + "0.1"},
                     {"read_where_seen_slack", "return speed taken at the first slack step instead of at x = 0",
                      speeds + "0.1"}},
          .run = run};
}

}  // namespace talus::verification::problems::damped_bungee
