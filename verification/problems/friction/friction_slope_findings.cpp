#include "verification/problems/friction/friction_findings.hpp"
#include "verification/study/scenes/sliding_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

constexpr double stiffness = 2e6;  // of the normal and of the tangential spring

/// Relative round-off of the normal force: the overlap is the difference of two lengths of half a metre.
double normal_round_off(const Slope& slope) {
  const double overlap = slope_mass * slope_gravity * std::cos(slope.angle) / slope.normal_stiffness;
  return 0.5 * 0x1p-53 / overlap;
}

struct SlopeRun {
  State end{};
  std::vector<double> time{}, speed{}, rim{};  ///< of every step, if watched; `rim` is -radius x spin
  double largest_balance_error{};              ///< largest energy balance error
};

SlopeRun run_slope(const Slope& slope, const Setup& setup, double step, double end, bool watched, Findings& findings) {
  Slope given = slope;
  if (setup.has("friction_halved")) given.friction *= 0.5;
  const Scene scene = slope_scene(given);
  SlopeRun run;
  RunLedger ledger{scene.model, first_state(scene)};
  const Watcher watch = [&](const State& state, const StepInfo&) {
    run.time.push_back(state.t);
    run.speed.push_back(state.v[0]);
    run.rim.push_back(state.v.size() > 2 ? -slope_radius * state.v[2] : 0.0);
    (void)ledger(state);
  };
  run.end = run_scene(scene, VelocityVerlet{}, {step, end, end, true}, findings, watched ? watch : Watcher{}).state;
  run.largest_balance_error = ledger.energy().largest_energy_balance_error();
  return run;
}

/// Time at which the slip rate first falls to zero. Linear interpolation between steps is exact while the disc slides.
double end_of_slip(const SlopeRun& run, double arm) {
  for (std::size_t i = 1; i < run.time.size(); ++i) {
    const double before = run.speed[i - 1] - run.rim[i - 1] * arm / slope_radius;
    const double now = run.speed[i] - run.rim[i] * arm / slope_radius;
    if (now <= 0.0) return run.time[i - 1] + (run.time[i] - run.time[i - 1]) * before / (before - now);
  }
  return std::nan("");
}

Figure rolling_figure(const SlopeRun& run, const reference::DraggedSlider& slider, double speed) {
  Series centre{"centre, solver", {}, {}, Style::points}, rim{"rim, solver", {}, {}, Style::points};
  for (std::size_t i = 0; i < run.time.size(); i += run.time.size() / 48) {
    centre.add(run.time[i], run.speed[i]);
    rim.add(run.time[i], run.rim[i]);
  }
  const double meets = speed / (3.0 * slider.friction * slope_gravity);
  const double last = run.time.back();
  return {.name = "rolling",
          .title = "From sliding to rolling",
          .caption =
              "Speeds of the centre and of the rim, $r\\omega$, of a disc that starts on a table with $u_0$ = 3 m/s "
              "and without spin. Lines: rigid disc, whose speeds become equal at the time $u_0/(3\\mu g)$, at two "
              "thirds of $u_0$.",
          .x = {.label = "time", .unit = "s"},
          .y = {.label = "speed", .unit = "m/s"},
          .series = {{"centre, exact", {0.0, meets, last}, {speed, 2.0 / 3.0 * speed, 2.0 / 3.0 * speed}, Style::lines},
                     {"rim, exact", {0.0, meets, last}, {0.0, 2.0 / 3.0 * speed, 2.0 / 3.0 * speed}, Style::lines},
                     centre,
                     rim}};
}

/// Mean accelerations over 0.05 s from rest, with the spring preloaded.
struct SlopeSweep {
  std::vector<double> tangents, accelerations;
  double farthest{};  ///< relative error against the reference
  double rigid{};     ///< relative difference between the reference and a rigid body
};

double rigid_acceleration(const Slope& slope) {
  const double sine = std::sin(slope.angle), cosine = std::cos(slope.angle);
  const double sliding = slope_gravity * (sine - slope.friction * cosine);
  return std::max(slope.rolls ? slope_gravity * sine * 2.0 / 3.0 : 0.0, sliding);
}

SlopeSweep sweep_slopes(bool rolls, const Setup& setup, Findings& findings) {
  SlopeSweep sweep;
  const double threshold = (rolls ? 3.0 : 1.0) * mu;
  for (int i = 1; i <= (setup.coarse ? 6 : 24); ++i) {
    const double tangent = threshold * i / (setup.coarse ? 3.0 : 12.0) * 1.02;
    Slope slope{rolls, std::atan(tangent), mu, stiffness, stiffness, 0.0, true};
    const double time = 0.05;
    const reference::DraggedSliderMotion exact{dragged_slider(slope), time};
    Slope given = slope;
    if (setup.has("disc_that_cannot_spin")) given.rolls = false;
    const SlopeRun run = run_slope(given, setup, 2e-5, time, false, findings);
    const double a = run.end.v[0] / time, reference = exact.at(time).speed_gain / time;
    sweep.tangents.push_back(tangent);
    sweep.accelerations.push_back(a);
    // A block at rest has no acceleration: its error is relative to gravity along the slope.
    const double scale = reference == 0.0 ? slope_gravity * std::sin(slope.angle) : reference;
    keep_largest(sweep.farthest, std::abs(a - reference) / scale);
    keep_largest(sweep.rigid, std::abs(reference - rigid_acceleration(slope)) / scale);
  }
  return sweep;
}

Figure slope_figure(const SlopeSweep& disc, const SlopeSweep& block) {
  Series rolls{"disc, exact", {}, {}, Style::lines}, holds{"block, exact", {}, {}, Style::lines};
  for (int i = 0; i <= 200; ++i) {
    const double tangent = 1.9 * i / 200.0;
    Slope slope{true, std::atan(tangent), mu, stiffness, stiffness, 0.0, true};
    rolls.add(tangent, rigid_acceleration(slope));
    slope.rolls = false;
    if (tangent > 2.1 * mu) continue;
    holds.add(tangent, rigid_acceleration(slope));
  }
  return {.name = "slopes",
          .title = "Acceleration down a slope",
          .caption =
              "A disc rolls up to $\\tan\\theta = 3\\mu$ and slides beyond; a block sticks up to $\\tan\\theta = "
              "\\mu$; $\\mu$ = 0.3. Lines: rigid bodies.",
          .x = {.label = "tangent of the slope angle"},
          .y = {.label = "acceleration", .unit = "m/s^2"},
          .series = {rolls,
                     holds,
                     {"disc, solver", disc.tangents, disc.accelerations, Style::points},
                     {"block, solver", block.tangents, block.accelerations, Style::crosses}},
          .slopes = {},
          .lines = {{'x', 3.0 * mu, "3 mu"}, {'x', mu, "mu"}}};
}

/// Checks slopes a thousandth below and above the slip threshold.
void check_threshold(Findings& findings, const Setup& setup, bool rolls, const std::string& name) {
  for (const double ratio : {0.999, 1.001}) {
    Slope slope{rolls, 0.0, mu, stiffness, stiffness, 0.0, true};
    slope.angle = std::atan(ratio * mu * dragged_slider(slope).mobility);
    Slope given = slope;
    if (setup.has("slope_too_flat")) given.angle *= 0.998;
    if (setup.has("slope_too_steep")) given.angle *= 1.002;
    const double time = 0.2;
    const SlopeRun run = run_slope(given, setup, 2e-5, time, false, findings);
    const double lost = run.end.work[static_cast<std::size_t>(Mechanism::friction)];
    if (ratio < 1.0) {
      findings.expect_exact({"below_threshold/" + name, "friction work at 0.999 of the slip threshold, " + name}, lost,
                            0.0, "below the friction limit the contact does not slip", "J");
      continue;
    }
    const reference::DraggedSlider slider = dragged_slider(slope);
    const double slipped = reference::DraggedSliderMotion{slider, time}.at(time).slipped;
    findings.expect(
        {"above_threshold/" + name, "friction work at 1.001 of the slip threshold, " + name}, lost,
        slider.friction * slider.normal_force * slipped,
        Tolerance::round_off(
            2e3 * normal_round_off(slope),
            "constant forces, which velocity Verlet integrates exactly; the acceleration of the slip is a thousandth "
            "of the force that contains the round-off of the normal force (an overlap of 1e-5 m as a difference of two "
            "lengths of half a metre): 1000 times that, and twice for its oscillation")
            .relative(),
        "J");
  }
}

/// Checks the order of the slip distance of a block that is released with an unstretched spring on a slope between mu/2
/// and mu: it slips once and then sticks.
void check_first_slip(Findings& findings, const Setup& setup) {
  Slope slope{false, std::atan(0.8 * mu), mu, stiffness, stiffness, 0.0, false};
  const reference::DraggedSlider slider = dragged_slider(slope);
  const double period = 2.0 * std::numbers::pi / std::sqrt(slider.tangential_stiffness / slider.mass);
  const double slipped = reference::DraggedSliderMotion{slider, 3.0 * period}.at(3.0 * period).slipped;
  // All runs start at t = 0, so that no onset can be varied. Steps that differ by up to a tenth vary the phase of the
  // slip instead.
  const std::vector<double> spread = golden_phases(fewest_phases);
  Convergence errors;
  for (const double count : doublings(64.0, 3)) {
    PhaseError error;
    for (const double phase : spread) {
      const SlopeRun run =
          run_slope(slope, setup, period / (count * (0.95 + 0.1 * phase)), 3.0 * period, false, findings);
      const double lost = run.end.work[static_cast<std::size_t>(Mechanism::friction)];
      error.add(lost / (slider.friction * slider.normal_force * slipped) - 1.0);
    }
    errors.add(1.0 / count, error.rms());
  }
  findings.expect_order("order of the slip distance of a block released on a slope", errors, 1.8, 2.2,
                        "velocity Verlet; a stretch beyond the friction limit is reduced to the limit within the same "
                        "step, which causes an error of the square of the step");
}

}  // namespace

void check_rolling(Findings& findings, const Setup& setup) {
  const double speed = 3.0, step = 2e-5, end = 0.6;
  const Slope slope{true, 0.0, mu, stiffness, stiffness, speed, true};
  const reference::DraggedSlider slider = dragged_slider(slope);
  const reference::DraggedSliderMotion exact{slider, end};
  Slope given = slope;
  if (setup.has("disc_that_cannot_spin")) given.rolls = false;
  const SlopeRun run = run_slope(given, setup, step, end, true, findings);
  const double arm = slope_radius - 0.5 * slope_mass * slope_gravity / stiffness;
  const double slip_ends = end_of_slip(run, arm);
  findings.expect_round_off({"rolling_start/reference", "start time of rolling over that of the reference"},
                            slip_ends / exact.phases()[1].begin, 1.0, 2.0 * normal_round_off(slope),
                            "constant forces, which velocity Verlet integrates exactly: the round-off of the overlap, "
                            "1e-5 m as a difference of two lengths of half a metre, and its oscillation");
  findings.expect_model({"rolling_start/rigid", "start time of rolling over u0/(3 mu g)"},
                        slip_ends * 3.0 * mu * slope_gravity / speed, 1.0,
                        2.0 * slope_mass * slope_gravity / stiffness / slope_radius / 3.0 * 1.05,
                        "friction acts on the arm r - d/2: n = 3 - 2 d/r instead of 3, and 5 % for the next power");
  const double swing = reference::swing_after_slip(slider);
  double largest = 0.0;
  for (std::size_t i = 0; i < run.time.size(); ++i) {
    if (run.time[i] > exact.phases()[1].begin + step)
      keep_largest(largest, run.speed[i] - run.rim[i] * arm / slope_radius);
  }
  const double wh = std::sqrt(3.0 * stiffness / slope_mass) * step;
  findings.expect_truncation("slip rate of the oscillation after sliding over mu g sqrt(3 m/k_s)", largest / swing, 1.0,
                             0.125 * wh * wh, 2.0,
                             "the largest of samples a step apart misses the peak by up to (w h)^2/8, and the "
                             "oscillation by velocity Verlet has an error of the same size");
  findings.expect_model(
      "speed of the rolling disc", run.end.v[0], 2.0 / 3.0 * speed, swing / 3.0,
      "the spring oscillates with the slip rate mu g sqrt(3 m/k_s), a third of which is in the speed of the centre",
      "m/s");
  const double lost = run.end.work[static_cast<std::size_t>(Mechanism::friction)];
  const double energy = 0.5 * slope_mass * speed * speed;
  findings.expect_model({"slider_loss", "energy lost by the slider, over a third of that at the start"},
                        lost / (energy / 3.0), 1.0, slope_mass * slope_gravity / stiffness / slope_radius / 1.5 * 1.05,
                        "friction acts on the arm r - d/2: n = 3 - 2 d/r instead of 3, and 5 % for the next power");
  const double spring = 0.5 * stiffness * slider.stretch * slider.stretch;
  findings.expect_truncation({"sliding_balance", "energy balance error, disc from sliding to rolling"},
                             run.largest_balance_error / energy, 0.0, 0.25 * wh * wh * spring / energy, 1.2,
                             "the balance under constant forces is exact to round-off; by velocity Verlet the energy "
                             "of the remaining oscillation, mu^2 N^2/(2 k_s), fluctuates by (w h)^2/4 of it");
  findings.figure(rolling_figure(run, slider, speed));
}

void check_slopes(Findings& findings, const Setup& setup) {
  const SlopeSweep disc = sweep_slopes(true, setup, findings), block = sweep_slopes(false, setup, findings);
  const Slope steepest{true, std::atan(6.2 * mu), mu, stiffness, stiffness, 0.0, true};
  const std::string reason =
      "constant forces, which velocity Verlet integrates exactly; the round-off of the overlap and its oscillation, "
      "relative to net forces of the size of the friction";
  findings.expect_round_off(
      {"slopes/disc", "acceleration of a disc on slopes, largest relative error against the reference"}, disc.farthest,
      0.0, 3.0 * normal_round_off(steepest), reason);
  findings.expect_round_off(
      {"slopes/block", "acceleration of a block on slopes, largest relative error against the reference"},
      block.farthest, 0.0, 30.0 * normal_round_off(steepest),
      "as for the disc; at 1.02 times the slip threshold the net force is a fiftieth of the friction: 50 times half a "
      "unit in the last place of the overlap's lengths, and a fifth for the oscillation");
  findings.expect_model(
      {"slopes/rigid", "acceleration of a disc on slopes, largest relative difference of reference and rigid disc"},
      disc.rigid, 0.0, slope_mass * slope_gravity / stiffness / slope_radius / 3.0,
      "with the arm r - d/2, n = 3 - 2 d/r changes 1 - 1/n by d/(3 r)");
  check_threshold(findings, setup, true, "disc");
  check_threshold(findings, setup, false, "block");
  if (setup.coarse) return;
  check_first_slip(findings, setup);
  findings.figure(slope_figure(disc, block));
}

}  // namespace talus::verification::problems
