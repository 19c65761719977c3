#include "verification/problems/friction/friction_findings.hpp"
#include "verification/study/impacts/oblique_runs.hpp"
#include "verification/study/runs/phase_sweep.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// Checks the order of the tangential speed after the impact. Returns the error with the largest number of steps per
/// contact (128, or 64 in coarse setups) times the square of that number.
double check_order(Findings& findings, const Setup& setup, const std::string& name, double kappa, double ratio,
                   const char* method, double width, std::vector<Convergence>& shown) {
  const reference::ObliqueImpact impact = oblique_disc(kappa, ratio);
  const reference::ObliqueRebound exact = reference::rebound(impact, reference::EndRule::clamped);
  const PhasedImpact phased{
      oblique_scene_of(impact, setup), std::numbers::pi, 1.2, 0, go_back, [&](std::span<const double> times) {
        return std::vector<double>(times.size(), impact.slip_rate - exact.speed_lost);
      }};
  const std::vector<double> counts = doublings(16.0, setup.coarse ? 3 : 4);
  const Offset offset = setup.has("commensurate_step") ? Offset::none : Offset::own;
  const Sweep found = sweep(phased, make_integrator(method), counts, offset);
  findings.expect_order(
      {"order_of_speed/" + name + "/" + method, "order of the tangential speed, " + name + ", " + method}, found.rms,
      2.0 - width, 2.0 + width,
      "start and end of contact, stick and slip each fall within a step, which causes errors of its square");
  shown.push_back(found.rms);
  return found.rms.errors().back() * found.steps.back() * found.steps.back();
}

void check_orders(Findings& findings, const Setup& setup) {
  struct Kind {
    const char* name;
    double kappa, ratio;
    double width;  ///< half the interval of the order: stick and slip phases that do not fit the steps scatter errors
  };
  const std::array kinds{Kind{"sliding throughout", 0.8, 5.0, 0.008},
                         Kind{"sticking throughout", 1.0 / 3.0, 0.6, 0.008},
                         Kind{"sticking, then sliding", 0.25, 0.5, 0.1}};
  std::vector<Convergence> shown;
  Figure figure{.name = "orders",
                .title = "Convergence of oblique impacts",
                .caption =
                    "Relative error of the tangential speed after an oblique impact, root mean square over 64 phases: "
                    "velocity Verlet (lines with points) and central difference (crosses).",
                .x = {.label = "step over contact time", .log = true},
                .y = {.label = "relative error", .log = true}};
  for (const Kind& kind : kinds) {
    for (const char* method : {"velocity_verlet", "central_difference"}) {
      if (setup.coarse && (kind.kappa != 1.0 / 3.0 || method != std::string{"velocity_verlet"})) continue;
      const double constant =
          check_order(findings, setup, kind.name, kind.kappa, kind.ratio, method, kind.width, shown);
      const bool crosses = std::string{method} == "central_difference";
      figure.series.push_back({fmt::format("{}, {}", kind.name, crosses ? "central difference" : "Verlet"),
                               shown.back().steps(), shown.back().errors(),
                               crosses ? Style::crosses : Style::linespoints});
      if (kind.kappa != 1.0 / 3.0 || crosses) continue;
      const double predicted = std::numbers::pi * std::numbers::pi / (2.0 * std::sqrt(90.0));
      findings.expect_model(
          {"sticking_error", "rms error of the tangential speed, sticking throughout, over its prediction"},
          constant / predicted, 1.0, 0.02,
          "both springs oscillate in phase, so that the error is that of the normal impact, pi^2/(2 sqrt(90) N^2); the "
          "next power of the step and the uneven 64 phases at the end leave 1 %");
    }
  }
  if (setup.coarse) return;
  figure.slopes = {{2.0, shown[2].steps().front(), 2.0 * shown[2].errors().front(), "h^2"}};
  findings.figure(figure);
}

/// Sliding throughout: in each step the friction impulse is mu times the normal impulse.
void check_gross_sliding(Findings& findings, const Setup& setup) {
  const reference::ObliqueImpact impact = oblique_disc(0.8, 5.0);
  const Scene scene = oblique_scene_of(impact, setup);
  double ratio = 0.0, spin = 0.0;
  PhaseError lost;
  const double radius = oblique_radius;
  for (std::size_t i = 0; i < fewest_phases; ++i) {
    const ObliqueRun run = run_oblique(scene, std::numbers::pi, 100.0, i, findings);
    const double along = impact.slip_rate - run.end.v[0], across = run.end.v[1] + 1.0;
    keep_largest(ratio, along / across / mu - 1.0);
    const double turned = run.end.v.size() > 2 ? -run.end.v[2] * radius : 0.0;
    keep_largest(spin, turned / (2.0 * along) - 1.0);
    lost.add(along / reference::speed_lost_by_gross_sliding(oblique_friction, 1.0, 1.0) - 1.0);
  }
  findings.expect_round_off(
      {"sliding/coulomb_ratio",
       "sliding impact: tangential over mu times normal speed change, largest error over 64 phases"},
      ratio, 0.0, 2e-14,
      "the tangential impulse is mu times the normal impulse in each step, from the first on: 100 sums of numbers up "
      "to 5, half a unit of the last place each, over 0.6: 7e-15 as a random walk, three times that for the worst");
  findings.expect_model(
      {"sliding/rim_speed",
       "sliding impact: rim speed gained over twice the tangential speed lost, largest error over 64 phases"},
      spin, 0.0, 3e-7, "friction acts on the arm r - d/2, d/r <= 2.5e-7");
  const double wh = std::numbers::pi / 100.5;
  findings.expect_model({"sliding/loss", "rms error of the tangential speed lost by sliding over its prediction"},
                        lost.rms() / (0.5 * wh * wh / (2.0 * std::sqrt(90.0))), 1.0, 0.05,
                        "half the error of the normal impact, (w h)^2/(2 sqrt(90)), because only e of 1 + e has an "
                        "error; the uneven 64 phases at the end leave 5 %");
}

/// The slip rate is reversed if the normal and the tangential spring oscillate in phase.
void check_full_stick(Findings& findings, const Setup& setup) {
  const reference::ObliqueImpact impact = oblique_disc(1.0 / 3.0, 0.9);
  const Scene scene = oblique_scene_of(impact, setup);
  PhaseError error;
  double work = 0.0;
  for (std::size_t i = 0; i < fewest_phases; ++i) {
    const ObliqueRun run = run_oblique(scene, std::numbers::pi, 100.0, i, findings);
    error.add(-run.slip_rate / impact.slip_rate - 1.0);
    work = std::max(work, run.end.work[static_cast<std::size_t>(Mechanism::friction)]);
  }
  const double wh = std::numbers::pi / 100.5;
  findings.expect_truncation(
      {"sticking_impact", "-v'/v of an impact that sticks throughout, k_s/k_n = 1/3, rms error"}, error.rms(), 0.0,
      wh * wh / (2.0 * std::sqrt(90.0)), 1.1,
      "the error of the normal impact, (w h)^2/(2 sqrt(90)), with a tenth more for the uneven 64 phases at the end");
}

/// Energy balance of sliding impacts: the slider's work is computed with the force at the end of each step.
void check_ledger(Findings& findings, const Setup& setup) {
  const double kappa = 0.8;
  const reference::ObliqueImpact impact = oblique_disc(kappa, 5.0);
  const Scene scene = oblique_scene_of(impact, setup);
  Convergence balance_errors;
  double ratio = 0.0;
  for (const double count : doublings(setup.coarse ? 512.0 : 128.0, setup.coarse ? 1 : 3)) {
    PhaseError balance_error;
    double predicted = 0.0;
    for (std::size_t i = 0; i < fewest_phases; ++i) {
      const double step = offset_step(std::numbers::pi, count, i);
      ObliqueRun run = run_oblique_at_step(scene, std::numbers::pi, step, i, findings);
      if (setup.has("slider_without_account"))
        run.balance_error -= run.end.work[static_cast<std::size_t>(Mechanism::friction)];
      balance_error.add(run.balance_error);
      predicted += std::pow(std::numbers::pi / 4.0 * mu * mu * (3.0 - 1.0 / kappa) * step, 2) / fewest_phases;
    }
    balance_errors.add(std::numbers::pi / (count + 0.5), balance_error.rms());
    ratio = balance_error.rms() / std::sqrt(predicted);
  }
  if (!setup.coarse)
    findings.expect_order({"sliding/order_of_balance", "order of the energy balance error, sliding impact"},
                          balance_errors, 0.95, 1.05,
                          "friction work is computed with the normal force at the end of each step");
  findings.expect_model({"sliding/balance", "energy balance error over its prediction, sliding impact"}, ratio, 1.0,
                        0.02,
                        "h/2 times the integral of mu N' (v - mu N'/k_s): pi/4 mu^2 m w v_n^2 (n - k/k_s) h; the next "
                        "power of the step, w h = 0.012, is 1 % of it");
}

/// Sliding impact with a dashpot: speed lost to friction, energy dissipated by the dashpot and lost at release.
void check_damped_sliding(Findings& findings) {
  const double xi = reference::damping_ratio(0.5, reference::EndRule::clamped);
  reference::ObliqueImpact impact = oblique_disc(0.8, 8.0);
  impact.normal.damping = 2.0 * xi;
  const reference::ImpactEvents exact = reference::impact_events(impact.normal, reference::EndRule::clamped);
  const double lost = reference::rebound(impact, reference::EndRule::clamped).speed_lost;
  const double held = 0.5 * exact.depth_at_end * exact.depth_at_end;
  const double eaten = 0.5 * (1.0 - 0.25) - held;
  const Scene scene = oblique_scene(impact, EndRule::clamped);
  PhaseError along, let_go, damped;
  for (std::size_t i = 0; i < fewest_phases; ++i) {
    const ObliqueRun run = run_oblique(scene, exact.contact_time, 100.0, i, findings);
    const auto recorded_work = [&run](Mechanism which) { return run.end.work[static_cast<std::size_t>(which)]; };
    along.add(impact.slip_rate - run.end.v[0] - lost);
    let_go.add(recorded_work(Mechanism::contact_release) / held - 1.0);
    damped.add(recorded_work(Mechanism::contact_damping) / eaten - 1.0);
  }
  const double wh = exact.contact_time / 100.5;
  // The contact sticks until the spring reaches the limit mu c v_n, which is present from the first instant.
  const double c = impact.normal.damping, stick = mu * c / (impact.tangential_stiffness * impact.slip_rate);
  findings.expect_model(
      {"sliding/half_e_loss", "tangential speed lost by sliding, e = 0.5, over that of a rigid impact, mu (1 + e) v_n"},
      lost / reference::speed_lost_by_gross_sliding(mu, 0.5, 1.0), 1.0, 1.2 * 0.5 * c * stick / 1.5,
      "the dashpot force acts from first contact, but the tangential spring reaches the friction limit only after the "
      "time t = mu c v_n/(k_s v): mu c v_n t/2 less, and a fifth for the next power of t");
  const double jump = 1.5 * c * wh / std::sqrt(12.0);
  const double lag = 0.5 * xi * xi * (reference::contact_angle(xi) - xi) / (1.0 - xi * xi) * wh;
  findings.expect_model(
      {"sliding/half_e_error", "rms error of the tangential speed lost by sliding, e = 0.5, over its prediction"},
      along.rms() / (mu * std::hypot(jump, lag)), 1.0, 0.04,
      "the force jump at first contact, resolved to +-h/2, changes the result by (1 + e) c v h u, u uniformly "
      "distributed, while the contact still sticks; the half-step lag of the dashpot changes e as in `restitution`; "
      "the next power of the step is 4 % of both");
  findings.expect({"release_loss", "energy lost at release of a contact with a dashpot, rms relative error"},
                  let_go.rms(), wh / (xi * std::sqrt(3.0)),
                  Tolerance::model(0.04,
                                   "release up to a step late, uniformly distributed, while the overlap decreases at e "
                                   "v: w h/(xi sqrt(3)); the next power of the step is 4 % of it")
                      .relative());
  findings.expect_truncation({"dashpot_energy", "energy dissipated by the dashpot of a contact, rms relative error"},
                             damped.rms(), 0.0, wh * 2.0 * xi / std::sqrt(12.0) / eaten, 1.1,
                             "its power jumps to c v^2 at first contact, which a step resolves to +-h/2, uniformly "
                             "distributed; the half-step lag of its velocity compensates some of that");
}

}  // namespace

void check_oblique_impacts(Findings& findings, const Setup& setup) {
  check_full_stick(findings, setup);
  check_orders(findings, setup);
  check_ledger(findings, setup);
  if (setup.coarse) return;
  check_gross_sliding(findings, setup);
  check_damped_sliding(findings);
}

}  // namespace talus::verification::problems
