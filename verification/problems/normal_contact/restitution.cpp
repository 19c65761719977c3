#include "verification/reference/impacts/restitution.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "verification/problems/normal_contact/calibration_findings.hpp"
#include "verification/problems/normal_contact/effective_mass_findings.hpp"
#include "verification/study/impacts/disc_bounce.hpp"
#include "verification/study/impacts/leapfrog_impact_error.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::restitution {
namespace {

Convergence restitution_errors(const Bounce& b, const Integrator& integrator, const std::vector<double>& steps,
                               Findings& findings, bool commensurate = false) {
  Convergence convergence;
  for (const double n : steps) {
    const ImpactErrors found =
        impact_errors([&b](double gap) { return disc_at(b, gap); }, b.exact, n, integrator, findings, commensurate);
    convergence.add(1.0 / n, found.restitution.rms());
  }
  return convergence;
}

/// Checks the order of e = 0.5 under one end rule for every method, and draws the errors with the leapfrog prediction.
void check_damped(EndRule rule, const std::vector<double>& steps, Figure& figure, Findings& findings,
                  const Setup& setup) {
  const Bounce b = bounce(0.5, rule, setup);
  for (const Integrator& integrator :
       {Integrator{VelocityVerlet{}}, Integrator{CentralDifference{}}, Integrator{RungeKutta4{}}}) {
    const std::string label = fmt::format("{}, {}", word_for(rule), talus::name(integrator));
    const Convergence found = restitution_errors(b, integrator, steps, findings);
    const auto claim = findings.in(fmt::format("integrator.{}", talus::name(integrator))),
               group = findings.in(word_for(rule));
    findings.expect_order(
        {fmt::format("order_of_e/{}/{}", word_for(rule), talus::name(integrator)), "order of the error of e, " + label},
        found, 0.93, 1.07,
        "the dashpot's force jumps at touch, which the steps resolve to half a step; the next power, w h = 0.2 of the "
        "first at 16 steps, tilts the fit by up to 0.05, uneven phases of the end (6 % of an rms) by 0.02");
    figure.series.push_back({label, found.steps(), found.errors(), Style::points});
  }
  Series predicted{.label = fmt::format("predicted, {}", word_for(rule)), .x = {}, .y = {}, .style = Style::lines};
  for (const double n : steps)
    predicted.add(1.0 / n, predicted_restitution_error(b, n));
  figure.series.push_back(predicted);
}

/// Checks contact time and largest overlap at 64 steps. The leapfrog's period is short by (w h)^2/24. The largest
/// sample lies within half a step of the turning point and the energy during contact is that at touch, so that the
/// error of the overlap is (w h)^2/2 [s (1 - s) - u (1 - u)], with the fractions of a step u at touch and s at half a
/// step before the turning point. Its root mean square equals that of the error of e.
void check_undamped_contact(const Bounce& elastic, Findings& findings) {
  constexpr double steps = 64.0;
  const ImpactErrors found = impact_errors([&elastic](double gap) { return disc_at(elastic, gap); }, elastic.exact,
                                           steps, VelocityVerlet{}, findings);
  const double wh = reduced_step(elastic.exact, steps);
  findings.expect({"elastic_time", "rms error of the undamped contact time, 64 steps"}, found.contact_time.rms(),
                  wh * wh / 24.0,
                  Tolerance::model(0.01,
                                   "error of the leapfrog's period; the next power is (w h)^2 = 0.002 of it, and the "
                                   "mean over steps of different lengths adds as much")
                      .relative());
  findings.expect(
      {"elastic_overlap", "rms error of the undamped largest overlap, 64 steps"}, found.largest_depth.rms(),
      second_order_constant / std::pow(steps + 0.5, 2),
      Tolerance::model(uneven_end, "fractions of a step at touch and largest overlap, in 64 unevenly spread pairs")
          .relative());
}

/// Checks the order of e = 1, and draws the errors with slopes for comparison.
void check_undamped(const std::vector<double>& steps, Figure& figure, Findings& findings, const Setup& setup) {
  const Bounce elastic = bounce(1.0, EndRule::attractive, setup);
  check_undamped_contact(elastic, findings);
  for (const Integrator& integrator : {Integrator{VelocityVerlet{}}, Integrator{RungeKutta4{}}}) {
    const Convergence found = restitution_errors(elastic, integrator, steps, findings, setup.has("commensurate_step"));
    const auto claim = findings.in(fmt::format("integrator.{}", talus::name(integrator)));
    findings.expect_order({fmt::format("order_undamped/{}", talus::name(integrator)),
                           fmt::format("order of the error of e, undamped, {}", talus::name(integrator))},
                          found, 1.85, 2.15,
                          "the force is continuous; its slope jumps at touch and end, which gives an error of h^2");
    figure.series.push_back(
        {fmt::format("e = 1, {}", talus::name(integrator)), found.steps(), found.errors(), Style::points});
    if (figure.slopes.empty()) {
      findings.expect({"elastic_16_steps", "rms error of e = 1 at 16 steps per contact"}, found.errors().front(),
                      second_order_constant / (16.5 * 16.5),
                      Tolerance::model(uneven_end,
                                       "pi^2/(2 sqrt(90) N^2) from the fractions of a step at touch and end; the next "
                                       "term, (w h)^2, is 4 % of it, the 64 uneven phases of the end add 6 %")
                          .relative());
      figure.slopes = {{1.0, 1.0 / 40.0, 0.06, "h"}, {2.0, 1.0 / 64.0, 0.1 * second_order_constant / 4096.0, "h^2"}};
    }
  }
}

/// Checks the error of e against the step for a disc on a plane: order one with a dashpot and two without one, for
/// every method. The figure also shows the predicted errors. Planted fault: `commensurate_step`.
void check_restitution_orders(Findings& findings, const Setup& setup) {
  Figure figure{.name = "error_of_e",
                .title = "Error of the restitution against the step",
                .caption =
                    "Root mean square over 64 phases, each with a different step; e = 0.5 unless the key names "
                    "another. Points: the solver. Lines: the error predicted from lag and jumps (damped); nothing is "
                    "fitted. With a dashpot every method is of first order, without a dashpot of second.",
                .x = {.label = "step / contact time", .log = true},
                .y = {.label = "relative error of e", .log = true}};
  const auto steps = doublings(16.0, setup.coarse ? 3 : 6);
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped})
    check_damped(rule, steps, figure, findings, setup);
  check_undamped(steps, figure, findings, setup);
  findings.figure(figure);
}

/// Ratio of measured to predicted errors; of several, the one farthest from 1.
struct Ratio {
  double farthest{1.0};
  void add(double measured, double predicted) { farthest = worst_ratio(farthest, measured / predicted); }
};

/// Checks e of one target, and adds the ratios of the other errors and a row of the table.
void check_bounce(double e, EndRule rule, Ratio& time, Ratio& depth, Ratio& identity, Table& table, Findings& findings,
                  const Setup& setup) {
  const Bounce b = bounce(e, rule, setup);
  const auto at = [&b](double gap) { return disc_at(b, gap); };
  const ImpactErrors found = impact_errors(at, b.exact, production_steps, VelocityVerlet{}, findings);
  const std::string name = fmt::format("{:g}, {}", e, word_for(rule));
  const double wh = reduced_step(b.exact, production_steps);
  const ImpactError predicted = leapfrog_impact_error(b.xi, same(rule));
  const auto group = findings.in(word_for(rule));
  findings.expect({"rms_error_of_e/" + name, "rms relative error of e = " + name}, found.restitution.rms(),
                  predicted_restitution_error(b, production_steps), near_prediction(rule));
  // With a weak dashpot, the only error is that of Verlet's period, which is short by (w h)^2/24.
  const double predicted_time = predicted.contact_time * wh + wh * wh / 24.0;
  time.add(found.contact_time.rms(), predicted_time);
  depth.add(found.largest_depth.rms(), predicted.largest_depth * wh);
  // ln e - 2 ln d_max: the shifts add up to xi w h; the jump enters once in e and twice in d_max^2, so that one
  // remains.
  identity.add(found.identity.rms(), 2.0 / std::sqrt(3.0) * b.xi * wh);
  table.rows.push_back(cells("{} | {:g} | {:.4f} | {:.5f} | {:.2e} | {:.2e} | {:.2e} | {:.2e} | {:.2e} | {:.2e}",
                             word_for(rule), e, b.xi, found.mean_restitution, found.restitution.rms(),
                             predicted_restitution_error(b, production_steps), found.contact_time.rms(), predicted_time,
                             found.largest_depth.rms(), predicted.largest_depth * wh));
}

void check_targets(Findings& findings, const Setup& setup) {
  Table table{.name = "targets",
              .caption =
                  "Disc on a plane, velocity Verlet, 100 steps per contact: relative errors, root mean square over 64 "
                  "phases, measured and predicted.",
              .columns = {"end rule", "wanted e", "xi", "mean e", "error of e", "predicted", "error of T", "predicted",
                          "error of d_max", "predicted"}};
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    Ratio time, depth, identity;
    for (const double e : {0.9, 0.7, 0.5, 0.3, 0.1})
      check_bounce(e, rule, time, depth, identity, table, findings, setup);
    const std::string over = fmt::format(" over the predicted, worst of e = 0.9 ... 0.1, {}", word_for(rule));
    findings.expect_model({fmt::format("contact_time/{}", word_for(rule)), "rms error of the contact time" + over},
                          time.farthest, 1.0, next_power,
                          "predicted from the half-step lag and the error of Verlet's period, without jumps; the next "
                          "power of the step is 4 % of it");
    findings.expect_model(
        {fmt::format("largest_overlap/{}", word_for(rule)), "rms error of the largest overlap" + over}, depth.farthest,
        1.0, next_power,
        "predicted from the half-step lag and the jump at touch; the next power of the step is 4 % of it");
    if (rule == EndRule::attractive) continue;
    findings.expect_model({"identity", "rms error of the identity e = (w d_max/v0)^2" + over}, identity.farthest, 1.0,
                          next_power, "as for both of its sides; the next power of the step is 4 % of it");
  }
  findings.table(table);
}

/// Checks the force obtained from the motion: attractive contacts end with a pull -c e v0, clamped ones never pull.
void check_pull(Findings& findings, const Setup& setup) {
  const Bounce b = bounce(0.5, EndRule::attractive, setup);
  const ImpactErrors found = impact_errors([&b](double gap) { return disc_at(b, gap); }, b.exact, production_steps,
                                           VelocityVerlet{}, findings);
  // dF/dt at the end is k d' + c d'' = -k e v0 (1 - 4 xi^2); the middle of the last full step lies between half a step
  // and one and a half steps before it.
  const double slope = b.e * (1.0 - 4.0 * b.xi * b.xi);
  const double lead = std::hypot(1.0, 1.0 / std::sqrt(12.0)) * reduced_step(b.exact, production_steps);
  findings.expect(
      {"pull", "pull at the end, e = 0.5, attractive, rms error over c e v0"}, found.pull.rms() / -b.exact.force_at_end,
      slope * lead / -b.exact.force_at_end,
      Tolerance::model(uneven_end,
                       "mean force of the last full step: the slope of F times the distance of that step's middle from "
                       "the end; the next power of the step is 4 % of it, the 64 uneven phases of the end add 6 %")
          .relative());
  double minimum = 0.0;
  for (const double e : {0.9, 0.5, 0.1}) {
    Bounce clamped = bounce(e, EndRule::clamped, setup);
    if (setup.has("pulls")) clamped.law.end_rule = EndRule::attractive;
    const ImpactErrors forces = impact_errors([&clamped](double gap) { return disc_at(clamped, gap); }, clamped.exact,
                                              production_steps, VelocityVerlet{}, findings);
    minimum = std::min(minimum, forces.minimum_deceleration);
  }
  findings.expect_exact({"no_pull", "largest pull of a clamped contact"}, minimum, 0.0,
                        "each kick adds a force >= 0 or none: the speed away from the plane never decreases");
}

/// Checks that only xi enters e: the same steps per contact, phases and dashpot rule at other stiffnesses.
void check_scales(Findings& findings, const Setup& setup) {
  const Bounce b = bounce(0.5, EndRule::attractive, setup);
  const double step = offset_step(b.exact.contact_time, production_steps, 0);
  const auto restitution_at = [&](double stiffness, double frequency) {
    // All lengths and times shrink with the frequency, so that speeds stay the same.
    scenes::BouncingDisc disc{.radius = 8.0 / frequency, .gap = 0.3 * step / frequency, .speed = 1.0, .contact = {}};
    const double of = setup.has("dashpot_without_stiffness") ? 1.0 : frequency;
    disc.contact = LinearSpringDashpot{stiffness, b.law.damping * of, b.rule};
    Scene scene = scenes::bouncing_disc(disc);
    scene.integrator = VelocityVerlet{};
    scene.plan = {step / frequency, 20.0 / frequency, 1.0, false};
    return follow_impact(scene, findings).restitution();
  };
  const double plain = restitution_at(1.0, 1.0);
  double powers = 0.0, decades = 0.0;
  for (int j = 1; j <= 8; ++j) {
    const double change = restitution_at(std::ldexp(1.0, 2 * j), std::ldexp(1.0, j)) - plain;
    if (std::abs(change) >= std::abs(powers)) powers = change;
  }
  for (const double k : {1e-2, 1e-1, 1e1, 1e2})
    keep_largest(decades, restitution_at(k, std::sqrt(k)) - plain);
  findings.expect_exact({"powers_of_two", "change of e, k = 4^1 ... 4^8, h = 2^-1 ... 2^-8"}, powers, 0.0,
                        "powers of two change exponents only: every operation rounds alike");
  findings.expect_round_off(
      "change of e over four decades of k", decades, 0.0, 5e-14,
      "110 steps round positions ten times the overlap, by 6.4e-16 of it rms; a sum of these errors changes e by pi "
      "sqrt(110/3) times that, 1.2e-14, in each of two runs: 1.7e-14, three times that for the worst");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("rms relative error of e =")) check_targets(findings, setup);
  if (setup.needs("pull")) check_pull(findings, setup);
  if (setup.needs("order of the error of e")) check_restitution_orders(findings, setup);
  if (setup.needs("change of e, k =")) check_scales(findings, setup);
  if (setup.needs("mass ratios")) check_masses(findings, setup);
  if (setup.needs("closing rate")) check_frames(findings, setup);
  if (setup.needs("off centre") || setup.needs("pivoted")) check_levers(findings, setup);
  if (setup.coarse) return;
  find_calibration_curves(findings);
  find_clamped_eq_21(findings);
  check_solver_formulas(findings);
  check_step_advice(findings);
  check_scene_calibration(findings);
}

}  // namespace

Case definition() {
  return {
      .id = "restitution",
      .title = "Restitution and damping",
      .requirements = {{"Eq. 17", {"largest_overlap", "pull", "no_pull", "elastic_overlap", "formula_overlap"}},
                       {"Eq. 19", {"pull", "order_of_e", "order_undamped"}},
                       {"Eq. 20", {"largest_overlap", "elastic_overlap", "rms_error_of_pairs", "formula_overlap"}},
                       {"Eq. 21",
                        {"rms_error_of_e", "powers_of_two", "change of e over four decades of k", "mass_ratios",
                         "moving_frames", "e_when_clamped", "formula_ratio"}},
                       {"Eq. 23, Eq. 24",
                        {"order_of_e/attractive/velocity_verlet", "order_of_e/attractive/central_difference",
                         "order_of_e/clamped/velocity_verlet", "order_of_e/clamped/central_difference",
                         "order_undamped/velocity_verlet"}},
                       {"B1", {"elastic_time", "elastic_overlap", "order_undamped", "elastic_16_steps"}},
                       {"B2",
                        {"rms_error_of_e/0.5, attractive", "contact_time/attractive", "pull", "order_of_e/attractive"}},
                       {"B3", {"rms_error_of_e/0.5, clamped", "contact_time/clamped", "no_pull", "order_of_e/clamped"}},
                       {"B4", {"largest_overlap", "identity", "formula_overlap"}},
                       {"B5", {"mass_ratios", "centre_of_mass", "moving_frames"}},
                       {"law.linear_spring_dashpot",
                        {"rms_error_of_e", "pull", "no_pull", "order_of_e", "order_undamped", "mass_ratios",
                         "rms_error_of_pairs"}},
                       {"end_rule.attractive",
                        {"attractive", "contact_time/attractive", "largest_overlap/attractive", "pull",
                         "order_of_e/attractive", "mean_e/attractive", "advised_step/attractive"}},
                       {"end_rule.clamped",
                        {"clamped", "contact_time/clamped", "largest_overlap/clamped", "identity", "no_pull",
                         "order_of_e/clamped", "mean_e/clamped", "e_when_clamped", "advised_step/clamped"}},
                       {"method.resultant", {"rms_error_of_e", "mass_ratios", "rms_error_of_pairs"}},
                       {"shape.circle", {"mass_ratios", "rms_error_of_pairs"}},
                       {"shape.half_plane", {"rms_error_of_e", "order_of_e", "order_undamped"}},
                       {"shape.rectangle", {"rms_error_of_pairs"}},
                       {"regime.linear_spring_dashpot.touching", {"rms_error_of_e", "elastic_overlap"}},
                       {"regime.linear_spring_dashpot.released", {"rms_error_of_e/0.5, clamped", "no_pull"}},
                       {"pair.circle.half_plane", {"rms_error_of_e", "order_of_e", "order_undamped"}},
                       {"pair.circle.circle", {"mass_ratios"}},
                       {"pair.circle.rectangle", {"rms_error_of_pairs"}}},
      .main_checks = {"rms_error_of_e/0.5, attractive", "rms_error_of_e/0.5, clamped",
                      "e of Eq. 21 for 0.5 when clamped, three digits", "order_of_e/attractive/velocity_verlet",
                      "order_undamped/velocity_verlet"},
      .source = "Mustoe & Huttelmaier 1993, section 3.6, Eqs. 17-21; Schwager & Poeschel 2007",
      .faults = {{"eq_21_halved", "Eq. 21 without its factor 2", "rms_error_of_e/0.5, attractive"},
                 {"never_pulls", "the attractive contact is clamped", "pull"},
                 {"pulls", "the clamped contact is attractive", "no_pull"},
                 {"eq_21_under_clamping", "the clamped contact uses the damping of Eq. 21",
                  "rms_error_of_e/0.5, clamped"},
                 {"commensurate_step", "the contact time is a multiple of the step", "order_undamped/velocity_verlet"},
                 {"dashpot_without_stiffness", "the dashpot does not grow with the square root of the stiffness",
                  "powers_of_two"},
                 {"masses_added", "the effective mass is the sum of the masses", "mass_ratios"},
                 {"closing_rate_with_plus", "the dashpot uses the sum of the velocities, as printed in Eq. 20",
                  "moving_frames"},
                 {"arm_forgotten", "the effective mass of the off-centre impact is that of the two masses alone",
                  "rms relative error of e, off centre"},
                 {"pin_forgotten", "the effective mass of the pivoted impact is that of the two masses alone",
                  "rms relative error of e, pivoted"}},
      .seconds = 3.0,
      .run = run};
}

}  // namespace talus::verification::problems::restitution
