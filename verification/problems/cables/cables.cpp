#include "verification/problems/cables/cable_findings.hpp"
#include "verification/reference/cables/cable_draw.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/impacts/followed_impact.hpp"
#include "verification/study/impacts/leapfrog_impact_error.hpp"
#include "verification/study/scenes/cable_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::cables {
namespace {

constexpr reference::Bungee fall{40.0, 2.0, 10.0, 0.7};

/// Elongation at the first lower turning point, and time from there to the next one.
struct Fall {
  double depth{}, period{};
  State end;
};

/// Vertex of the parabola through three values one step apart: its position in steps from the middle, and its value.
struct Turn {
  double offset{}, value{};
};
Turn turn_of(double before, double at, double after) {
  const double slope = 0.5 * (after - before), bend = after - 2.0 * at + before;
  return {-slope / bend, at - 0.5 * slope * slope / bend};
}

Fall run_fall(const CableLaw& law, double gravity, double step, const Integrator& method, Findings& findings) {
  const Scene scene = thrown_mass(law, fall.mass, 0.0, gravity);
  State state = scene.initial;
  state.q[0] -= fall.height;
  const double end = 1.8 * reference::bungee_period(fall);
  const CableRunResult run = run_cables(scene, state, method, {step, end, false, true}, findings);
  std::vector<Turn> turns;
  std::vector<double> times;
  const auto& e = run.elongation;
  for (std::size_t i = 1; i + 1 < e.size(); ++i) {
    if (!(e[i] > 0.0 && e[i] >= e[i - 1] && e[i] > e[i + 1])) continue;
    turns.push_back(turn_of(e[i - 1], e[i], e[i + 1]));
    times.push_back(run.time[i] + step * turns.back().offset);
  }
  if (turns.size() != 2) return {std::nan(""), std::nan(""), run.end};
  return {turns[0].value, times[1] - times[0], run.end};
}

}  // namespace

void check_bungee(Findings& findings, const Setup& setup) {
  const double period = reference::bungee_period(fall), deepest = reference::bungee_depth(fall);
  const double gravity = setup.has("weight_halved") ? 0.5 * fall.gravity : fall.gravity;
  const struct {
    const char* name;
    double depth, period;  ///< measured constants: relative errors over (w h)^2
  } methods[] = {{"velocity_verlet", 0.027, 0.034}, {"central_difference", 0.045, 0.0244}};
  for (const auto& method : methods) {
    Convergence depth, time;
    const auto counts = doublings(setup.coarse ? 512.0 : 64.0, setup.coarse ? 1 : 4);
    for (const double count : counts) {
      PhaseError of_depth, of_period;
      // The release at t = 0 leaves no onset to vary. Steps that vary by 10 % distribute the phases instead.
      for (const double phase : golden_phases(fewest_phases)) {
        const double step = period / (count * (0.95 + 0.1 * phase));
        const Fall found = run_fall(TensionOnly{fall.stiffness}, gravity, step, make_integrator(method.name), findings);
        of_depth.add(found.depth / deepest - 1.0);
        of_period.add(found.period / period - 1.0);
      }
      depth.add(1.0 / count, of_depth.rms());
      time.add(1.0 / count, of_period.rms());
    }
    const std::string name = method.name;
    const char* const reason =
        "the order of the method; the cable becomes taut and slack within a step, which causes errors of second order";
    if (!setup.coarse) {
      findings.expect_order({"order_of_depth/" + name, "order of the largest elongation in a fall, " + name}, depth,
                            1.9, 2.1, reason);
      findings.expect_order({"order_of_period/" + name, "order of the period of a fall, " + name}, time, 1.9, 2.1,
                            reason);
    }
    const double wh = std::sqrt(fall.stiffness / fall.mass) * period / counts.back();
    const char* const measured = "measured constant times (w h)^2, plus 20 % for other phases";
    findings.expect_truncation(
        {"depth/" + name, "largest elongation in a fall, rms relative error at the smallest step, " + name},
        depth.errors().back(), 0.0, method.depth * wh * wh, 1.2, measured);
    findings.expect_truncation({"period/" + name, "period of a fall, rms relative error at the smallest step, " + name},
                               time.errors().back(), 0.0, method.period * wh * wh, 1.2, measured);
    if (setup.coarse) return;
  }
  const double step = offset_step(period, 256.0, 0);
  const Fall a = run_fall(TensionOnly{fall.stiffness}, gravity, step, VelocityVerlet{}, findings);
  const Fall b = run_fall(ElasticPlastic{.stiffness = fall.stiffness}, gravity, step, VelocityVerlet{}, findings);
  findings.expect_exact(
      {"unyielding",
       "elastic_plastic cable that never yields, difference from a tension_only cable at the end of the fall"},
      a.end.q[0] - b.end.q[0], 0.0, "both laws use the same operations: k times the elongation", "m");
}

void check_damped_throw(Findings& findings, const Setup& setup) {
  const double xi = 0.2;
  const reference::Impact impact{1.0, 2.0 * xi, 1.0, 1.0};
  const reference::ImpactEvents exact = reference::impact_events(impact, reference::EndRule::clamped);
  const double damping = setup.has("dashpot_halved") ? 0.5 * impact.damping : impact.damping;
  const Scene scene = thrown_mass(TensionOnly{1.0, damping}, 1.0, 1.0);
  PhaseError exit, let_go, damped;
  double wh = 0.0;
  const double held = 0.5 * exact.depth_at_end * exact.depth_at_end;
  const double eaten = 0.5 * (1.0 - exact.restitution * exact.restitution) - held;
  for (const auto& [i, step, phase] : offset_phases(exact.contact_time, 100.0)) {
    wh += step / static_cast<double>(fewest_phases);
    State state = scene.initial;
    state.q[0] -= phase * step;
    const CableRunResult run = run_cables(scene, state, VelocityVerlet{}, {step, 20.0, true}, findings);
    exit.add(-run.end.v[0] / exact.restitution - 1.0);
    let_go.add(recorded_work(run.end, Mechanism::cable_release) / held - 1.0);
    damped.add(recorded_work(run.end, Mechanism::cable_damping) / eaten - 1.0);
  }
  const ImpactError predicted = leapfrog_impact_error(xi, reference::EndRule::clamped);
  findings.expect_model({"damped_exit", "exit speed on a cable with a dashpot, rms error over its prediction"},
                        exit.rms() / (predicted.restitution * wh), 1.0, 0.04,
                        "the half-step lag of the dashpot and the jump of its force when the cable becomes taut, as in "
                        "`restitution`; the next order in h is 4 % of it");
  findings.expect({"release_energy", "energy released by a cable with a dashpot, rms relative error"}, let_go.rms(),
                  wh / (xi * std::sqrt(3.0)),
                  Tolerance::model(0.04,
                                   "the release is late by a uniformly distributed fraction of a step, while the "
                                   "elongation decreases at e v: w h/(xi sqrt(3)); the next order in h is 4 % of it")
                      .relative());
  findings.expect_truncation(
      {"dashpot_energy", "energy dissipated by the dashpot of a cable, rms relative error"}, damped.rms(), 0.0,
      wh * 2.0 * xi / std::sqrt(12.0) / eaten, 1.1,
      "its power jumps to c v^2 when the cable becomes taut, at a time that is off by up to +-h/2, uniformly "
      "distributed; the half-step lag of its velocity compensates part of this");
}

namespace {

void run(Findings& findings, const Setup& setup) {
  check_bungee(findings, setup);
  check_damped_throw(findings, setup);
  check_yielding(findings, setup);
  check_breaking(findings, setup);
  check_hanger(findings, setup);
  if (setup.coarse) return;
  check_nets(findings);
  check_chains(findings);
}

}  // namespace

Case definition() {
  return {.id = "cables",
          .title = "Yielding and breaking cables",
          .requirements =
              {{"Eq. 14", {"order_of_depth", "order_of_period", "depth", "period", "damped_exit"}},
               {"D1", {"order_of_depth", "order_of_period", "depth", "period"}},
               {"D3", {"yield_limit", "plastic", "residual_stretch"}},
               {"D4",
                {"work_of_throws/two throws, linear hardening", "work_of_throws/three throws, tabulated hardening",
                 "residual_stretch/two throws, linear hardening", "residual_stretch/three throws, tabulated hardening",
                 "exit_speed/two throws, linear hardening", "exit_speed/three throws, tabulated hardening"}},
               {"D9", {"broken", "break", "located_breaks"}},
               {"law.tension_only",
                {"order_of_depth", "order_of_period", "depth", "period", "nets", "unyielding", "damped_exit",
                 "release_energy"}},
               {"law.elastic_plastic",
                {"unyielding", "yield_limit", "plastic", "work_of_throws", "residual_stretch", "exit_speed", "broken",
                 "hanger/speed", "hanger/order_of_speed", "hanger/merged_position", "merged_tension", "hanger/tensions",
                 "chains"}},
               {"mechanism.cable_damping", {"dashpot_energy"}},
               {"mechanism.cable_release", {"release_energy"}},
               {"mechanism.cable_yield", {"yield_balance", "work_of_throws"}},
               {"mechanism.cable_break", {"break", "break_balance"}},
               {"mechanism.hanger_break", {"hanger_energy", "hanger_balance", "hanger_loss"}},
               {"integrator.velocity_verlet",
                {"order_of_depth/velocity_verlet", "order_of_period/velocity_verlet", "depth/velocity_verlet",
                 "period/velocity_verlet", "plastic", "work_of_throws/two throws, perfectly plastic",
                 "residual_stretch/two throws, perfectly plastic", "exit_speed/two throws, perfectly plastic"}},
               {"integrator.central_difference",
                {"order_of_depth/central_difference", "order_of_period/central_difference", "depth/central_difference",
                 "period/central_difference"}},
               {"integrator.stormer_cowell", {"located_breaks"}},
               {"integrator.odeint_dopri5", {"hanger_loss", "hanger/exit_speed"}},
               {"regime.tension_only.slack, regime.tension_only.taut",
                {"order_of_depth", "order_of_period", "depth", "period"}},
               {"regime.tension_only.released", {"release_energy"}},
               {"regime.elastic_plastic.slack",
                {"yield_limit", "plastic/stretch", "plastic/order_of_stretch", "residual_stretch"}},
               {"regime.elastic_plastic.taut", {"unyielding"}},
               {"regime.elastic_plastic.yielding",
                {"plastic", "work_of_throws/two throws, perfectly plastic",
                 "residual_stretch/two throws, perfectly plastic", "exit_speed/two throws, perfectly plastic"}},
               {"regime.elastic_plastic.broken", {"break"}}},
          .main_checks = {"plastic/order_of_exit", "work_of_throws/three throws, tabulated hardening", "broken/weak",
                          "hanger_loss", "hanger_balance"},
          .source = "Mustoe & Huttelmaier 1993, sections 2.4 and 3.3, Eq. 14",
          .faults = {{"weight_halved", "gravity halved", "depth/velocity_verlet"},
                     {"dashpot_halved", "dashpot coefficient halved", "damped_exit"},
                     {"never_yields", "cables without a yield force", "plastic/exit"},
                     {"without_hardening", "cables with a constant yield force",
                      "work_of_throws/two throws, linear hardening"},
                     {"stretch_forgotten", "each throw starts with zero plastic stretch",
                      "residual_stretch/three throws, tabulated hardening"},
                     {"strength_unread", "cables and hangers 0.2 % weaker", "broken/strong"},
                     {"break_not_booked", "the energy released by a cable break is omitted from the energy balance",
                      "break_balance/error"},
                     {"hanger_not_booked", "the energy lost in a hanger break is omitted from the energy balance",
                      "hanger_balance"},
                     {"two_cables_side_by_side",
                      "after the break, two stiffnesses added as in parallel instead of in series", "merged_tension"}},
          .run = run};
}

}  // namespace talus::verification::problems::cables
