#include "verification/problems/speed_accuracy/failure_rows.hpp"
#include "verification/study/impacts/pressed_disc.hpp"
#include "verification/study/scenes/sliding_scenes.hpp"
#include "verification/study/scenes/turned_pair.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// Distance that a block creeps down a slope within `time` if friction is mu N v/v_reg up to mu N, by classical
/// Runge-Kutta from rest.
double crept(const Slope& slope, double v_reg, double time, long steps) {
  const double normal = slope_gravity * std::cos(slope.angle), drive = slope_gravity * std::sin(slope.angle);
  const auto rate = [&](double v) { return drive - slope.friction * normal * std::clamp(v / v_reg, -1.0, 1.0); };
  const double h = time / static_cast<double>(steps);
  double x = 0.0, v = 0.0;
  for (long n = 0; n < steps; ++n) {
    const double k1 = rate(v), k2 = rate(v + 0.5 * h * k1), k3 = rate(v + 0.5 * h * k2), k4 = rate(v + h * k3);
    x += h * (v + h * (k1 + k2 + k3) / 6.0);
    v += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
  }
  return x;
}

double swing_time(const Slope& slope) { return 2.0 * std::numbers::pi / std::sqrt(slope.slip_stiffness / slope_mass); }

/// Stretch of the spring that holds a block on a slope.
double held_stretch(const Slope& slope) {
  return slope_mass * slope_gravity * std::sin(slope.angle) / slope.slip_stiffness;
}

/// Runs a block on a slope of half the friction coefficient, pushed so that the force of its spring oscillates between
/// a tenth and nine tenths of the limit. Returns the largest displacement over the amplitude.
double check_swinging_block(const Slope& slope, double step, long steps, Findings& findings) {
  Scene pushed = slope_scene(slope);
  const double swing = 0.8 * held_stretch(slope), w = 2.0 * std::numbers::pi / swing_time(slope);
  pushed.initial.v[0] = w * swing;
  double farthest = 0.0;
  const Watcher watch = [&](const State& seen, const StepInfo&) {
    farthest = std::max(farthest, std::abs(seen.q[0]) / swing);
  };
  const RunEnd run = run_steps(pushed, VelocityVerlet{}, step, steps, findings, watch);
  const double eta = w * step, swings = eta * static_cast<double>(steps) / (2.0 * std::numbers::pi);
  findings.expect_truncation(
      "creep: largest displacement of the held block, spring force oscillating up to 0.9 of the limit, over the "
      "amplitude",
      farthest, 1.0 / std::sqrt(1.0 - 0.25 * eta * eta), eta * eta / (8.0 * swings * swings), 3.0,
      "Verlet conserves v^2 + w^2 x^2 (1 - (w h)^2/4); the turning points of n oscillations are spread over a step, so "
      "that one is sampled within 1/n of half a step");
  findings.expect_exact("creep: work of the slider during this oscillation",
                        run.state.work[static_cast<std::size_t>(Mechanism::friction)], 0.0,
                        "below its limit the slider does not move", "J");
  return farthest;
}

/// Accelerations of a disc held by eight fixed discs around it, with the contacts in one order or the reverse.
std::vector<double> accelerations(bool backwards) {
  SceneBuilder builder;
  const BodyId disc = builder.add_free("disc", 1.0, 1.0, Circle{1.0});
  std::vector<BodyId> around;
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.1 + 0.7 * i;
    around.push_back(builder.add_fixed(fmt::format("post{}", i), Circle{1.0},
                                       {(1.9 - 0.01 * i) * std::cos(angle), (1.9 - 0.01 * i) * std::sin(angle)}));
  }
  if (backwards) std::reverse(around.begin(), around.end());
  for (std::size_t i = 0; i < around.size(); ++i)
    builder.add_contact(fmt::format("contact{}", i), around[i], disc, LinearSpringDashpot{1.0, 0.0, EndRule::clamped});
  const Dynamics dynamics{builder.build()};
  RigidBodySystem system{dynamics};
  State state = rest_state(dynamics.model());
  system.begin(state);
  Rates rates{state};
  system.evaluate(state, rates);
  return rates.v;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    keep_largest(largest, a[i] - b[i]);
  return largest;
}

}  // namespace

FailureFound check_turned_history(Findings& findings, const Setup& setup) {
  constexpr long steps = 256;
  using namespace turned_pair;
  // Error of a stretch stored in world axes while the pair turns; it is largest after half a turn.
  double off = 0.0;
  for (long n = 0; n <= steps; ++n) {
    const double angle =
        setup.has("spring_turned_along") ? 0.0 : 2.0 * std::numbers::pi * static_cast<double>(n) / steps;
    keep_largest(off, std::hypot(std::cos(angle) - 1.0, std::sin(angle)));
  }
  const Turn turn = turned<RigidBodySystem>(steps, {});
  findings.expect_exact("turned history: largest error of a friction force stored in world axes, over the force", off,
                        2.0, "2 sin(angle/2): the opposite sign after half a turn");
  const double drift = turn.stretch / first_stretch;
  findings.expect_round_off(
      "turned history: friction gained by the solver in a full turn of 256 steps, over the force", drift,
      exact_drift(steps) / first_stretch, 22.6 * 12.0 * 0x1p-52 / first_stretch,
      "512 steps, each with a dozen roundings of positions of up to 2, of either sign (case turning_pair)");
  findings.expect_round_off("turned history: largest change of the friction force in addition, over the force",
                            turn.drag / (slip_stiffness * first_stretch), 0.0,
                            4.0 * 12.0 * 0x1p-52 / (slip_stiffness * first_stretch),
                            "a dozen roundings of a force of 4 and of its directions");
  return {fmt::format("stored in world axes: error of {:.1f} F", off),
          fmt::format("solver, 256 steps per turn: {:.3f} F, explained by the chords", drift)};
}

FailureFound check_creep(Findings& findings, const Setup& setup) {
  const double mu = 0.3, v_reg = 1e-3;
  const Slope slope{false, std::atan(0.5 * mu), mu, 2e6, 2e6, 0.0, true};
  const double step = swing_time(slope) / 50.0;
  const long steps = setup.coarse ? 20000 : setup.tier == Tier::full ? 10000000 : 1000000;
  const double time = step * static_cast<double>(steps);
  // From rest the block approaches the creep speed as 1 - exp(-t/tau), tau = v_reg/(mu g cos).
  const double speed = v_reg * std::tan(slope.angle) / mu, lag = v_reg / (mu * slope_gravity * std::cos(slope.angle));
  const double creep = crept(slope, v_reg, time, std::lround(8.0 * time / lag));
  findings.expect_truncation(
      "creep: displacement of a block with friction of mu N v/v_reg, over v_reg F_t t/(mu N)",
      creep / (speed * (time - lag)), 1.0, lag / time / (120.0 * 4096.0) + 8.0 * time / lag * 0x1p-54, 1.0,
      "steps of an eighth of v_reg/(mu g cos), for which Runge-Kutta has an error of (1/8)^4/120 while the block "
      "accelerates; afterwards equal displacements are added, with the same rounding for many steps");
  Slope held = slope;
  if (setup.has("slope_too_steep")) held.angle = std::atan(1.01 * mu);
  const RunEnd run = run_steps(slope_scene(held), VelocityVerlet{}, step, steps, findings);
  findings.expect_round_off(
      {"creep", "creep: displacement of a block held by spring and slider, over the stretch of its spring"},
      run.state.q[0] / held_stretch(slope), 0.0, 0x1p-53 * std::sqrt(static_cast<double>(steps)),
      "the spring oscillates about its equilibrium by a rounding of its force, to which each step adds another one of "
      "either sign");
  const double farthest = check_swinging_block(slope, step, steps / 10, findings);
  return {fmt::format("F = mu N v/v_reg: {:.2f} m in {:.0f} s", creep, time),
          fmt::format("spring and slider, {} steps: {:g} m; oscillation up to 0.9 mu N: {:.3f} of the amplitude", steps,
                      std::abs(run.state.q[0]), farthest)};
}

FailureFound check_latch_reload(Findings& findings, const Setup& setup) {
  // K1 = 64, K2 = 256: pressed to an overlap of 1/2 the spring has a residual overlap of 3/8; at 1/4 it has no force,
  // although the surfaces have not separated.
  const auto reload = [](double back, bool forgets) {
    PressedDisc disc{false};
    disc.press(0.5);
    disc.press(back);
    if (forgets) disc.forget();
    const double before = disc.work();
    disc.press(0.5);
    disc.press(back);
    return disc.work() - before;
  };
  constexpr double soft = 64.0, stiff = 256.0, maximum = 0.5, slack = 0.25;
  const double had_back = 0.5 * soft * maximum * soft * maximum / stiff;
  const char* why = "all overlaps, forces and their products are short sums of powers of two";
  const double forgotten = reload(slack, !setup.has("retained")), kept = reload(slack, false),
               parted = reload(-0.0625, false);
  findings.expect_exact(
      {"latch_reload/lost", "latch reload: work of a reload before the surfaces separate, history lost at its start"},
      forgotten, 0.5 * soft * (maximum * maximum - slack * slack) - had_back, why, "J");
  findings.expect_exact({"latch_reload/before", "latch reload: work of a reload before the surfaces separate"}, kept,
                        0.0, why, "J");
  findings.expect_exact({"latch_reload/after", "latch reload: work of a reload after the surfaces have separated"},
                        parted, 0.5 * soft * maximum * maximum - had_back, why, "J");
  return {fmt::format("history lost while force-free: a reload costs {:g} J", forgotten),
          fmt::format("before separation {:g} J, after it {:g} J", kept, parted)};
}

FailureFound check_order_of_sums(Findings& findings, const Setup& setup) {
  const std::vector<double> forward = accelerations(false), again = accelerations(false);
  const std::vector<double> backward = accelerations(!setup.has("same_order"));
  const double fails = difference(forward, backward), holds = difference(forward, again);
  findings.expect_between("order of sums: acceleration by eight contacts, reversed minus listed order, over rounding",
                          fails / 0x1p-53, 0.01, 4.0,
                          "eight forces of up to 0.17 added in either order: partial sums below 1/2 are rounded to "
                          "2^-54 in each of seven additions; any difference at all is the failure");
  findings.expect_exact("order of sums: difference of two evaluations in one order", holds, 0.0,
                        "always the model's order");
  return {fmt::format("eight contacts in reversed order: accelerations differ by {:.1g}", fails),
          fmt::format("the model's order: {:g}", holds)};
}

}  // namespace talus::verification::problems
