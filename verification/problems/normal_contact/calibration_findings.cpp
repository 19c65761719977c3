#include "verification/problems/normal_contact/calibration_findings.hpp"

#include "solver/calibrate/impact.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "verification/reference/impacts/pivoted_cylinder.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/common_formula.hpp"
#include "verification/study/impacts/followed_impact.hpp"
#include "verification/study/impacts/leapfrog_impact_error.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// Mean over 64 phases of e of a disc on a plane: velocity Verlet with `steps` steps per contact.
double measured_restitution(const LinearSpringDashpot& law, double steps, Findings& findings) {
  const double time = reference::impact_events({law.stiffness, law.damping, 1.0, 1.0}, same(law.end_rule)).contact_time;
  double mean = 0.0;
  for (const Phase& phase : offset_phases(time, steps)) {
    const double gap = phase.lead();
    Scene scene = scenes::bouncing_disc({.radius = 8.0, .gap = gap, .speed = 1.0, .contact = law});
    scene.integrator = VelocityVerlet{};
    scene.plan = {phase.step, gap + 2.0 * time + 4.0 * phase.step, time, false};
    mean += follow_impact(scene, findings).restitution() / static_cast<double>(fewest_phases);
  }
  return mean;
}

double relative(double measured, double reference) {
  return reference == 0.0 ? std::abs(measured) : std::abs(measured / reference - 1.0);
}

}  // namespace

void find_calibration_curves(Findings& findings) {
  Figure figure{.name = "restitution",
                .title = "Restitution against damping ratio",
                .caption =
                    "Points: the solver, 200 steps per contact, mean over 64 phases. Lines: closed forms. The "
                    "attractive contact never separates beyond $\\xi = 1$; the clamped one does.",
                .x = {.label = "damping ratio xi", .min = 0.0},
                .y = {.label = "restitution e", .min = 0.0, .max = 1.0}};
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    const bool attractive = rule == EndRule::attractive;
    const std::string label = attractive ? "attractive" : "clamped";
    Series points{.label = label + ", solver", .style = Style::points};
    Series curve{.label = label + ", closed form", .style = Style::lines};
    PhaseError errors;
    for (int i = 0; i < 20; ++i) {
      const double e = 1.0 - 0.05 * i;
      const double xi = reference::damping_ratio(e, same(rule));
      points.add(xi, measured_restitution(dashpot_of(xi, 1.0, 1.0, rule), 200.0, findings));
      errors.add(points.y.back() - e);
    }
    for (double xi = 0.0; xi < (attractive ? 0.999 : 2.0); xi += 0.01)
      curve.add(xi, reference::restitution(xi, same(rule)));
    // The jumps cancel in the mean over phases, and the lag remains: |shift| e w h, with w h = w T/200.
    double shift = 0.0;
    for (const double xi : points.x) {
      const auto events = reference::impact_events({1.0, 2.0 * xi, 1.0, 1.0}, same(rule));
      keep_largest(shift, std::abs(leapfrog_restitution_shift(xi, same(rule))) * events.restitution *
                              events.contact_time / 200.5);
    }
    findings.expect(
        {"mean_e/" + std::string{label}, "largest error of the mean e, e = 0.05 ... 1, " + label}, errors.max(), shift,
        (attractive
             ? Tolerance::model(0.05,
                                "shift of e by the half-step lag at 200 steps per contact, largest over the twenty "
                                "targets; the jump at the end, at 64 uneven phases, adds up to 5 % of it to the mean")
             : Tolerance::model(0.016,
                                "shift of e by the half-step lag at 200 steps per contact, largest over the twenty "
                                "targets; the jump cancels in the mean, the next power of the step is w h = 1.6 %"))
            .relative());
    figure.series.insert(figure.series.end(), {points, curve});
  }
  findings.figure(figure);
}

void find_clamped_eq_21(Findings& findings) {
  Table table{.name = "clamped_eq_21",
              .caption =
                  "The damping of Eq. 21 under the clamped rule gives too large an e; the clamped formula solved for "
                  "the damping ratio gives the wanted e (3200 steps per contact, mean over 64 phases).",
              .columns = {"wanted e", "xi by Eq. 21", "attractive", "clamped", "exact clamped", "xi, clamped formula",
                          "clamped, with that xi"}};
  Figure figure{.name = "clamped_eq_21",
                .title = "Eq. 21 under both end rules",
                .caption = "Restitution of the solver with the damping of Eq. 21; on the diagonal it is as wanted.",
                .x = {.label = "wanted restitution", .min = 0.0, .max = 1.0},
                .y = {.label = "restitution", .min = 0.0, .max = 1.0},
                .series = {{"attractive, solver", {}, {}, Style::points},
                           {"clamped, solver", {}, {}, Style::points},
                           {"clamped, closed form", {}, {}, Style::lines},
                           {"as wanted", {0.0, 1.0}, {0.0, 1.0}, Style::lines}}};
  Table common = common_formula("clamped_restitution",
                                "**Restitution by Eq. 21 where the contact may not pull.** The damping of Eq. 21 is "
                                "meant to give $e$, and does if the contact may pull at its end. If it is clamped, the "
                                "exact $e$ is $\\exp(-2\\xi A)$, $A = \\arccos(\\xi)/\\sqrt{1 - \\xi^2}$, with the "
                                "damping ratio $\\xi$ of Eq. 21. Solver: mean of 64 phases, 3200 steps per contact.");
  const struct {
    double wanted;
    double given;
  } known[] = {{0.9, 0.902}, {0.7, 0.718}, {0.5, 0.550}, {0.3, 0.397}, {0.1, 0.253}};
  for (const auto& row : known) {
    const double xi = reference::damping_ratio(row.wanted, reference::EndRule::attractive);
    const double own = reference::damping_ratio(row.wanted, reference::EndRule::clamped);
    const double attractive = measured_restitution(dashpot_of(xi, 1.0, 1.0, EndRule::attractive), 3200.0, findings);
    const double clamped = measured_restitution(dashpot_of(xi, 1.0, 1.0, EndRule::clamped), 3200.0, findings);
    const double solved = measured_restitution(dashpot_of(own, 1.0, 1.0, EndRule::clamped), 3200.0, findings);
    findings.expect_model(
        {"e_when_clamped", fmt::format("e of Eq. 21 for {:g} when clamped, three digits", row.wanted)}, clamped,
        row.given, 5e-4, "half a unit in the third digit of the known value");
    const double exact = reference::restitution(xi, reference::EndRule::clamped);
    common.rows.push_back(cells("$e$ = {:g} wanted | {:g} | {:.4f} | {:+.1f} % | {:.4f}", row.wanted, row.wanted, exact,
                                100.0 * (row.wanted / exact - 1.0), clamped));
    table.rows.push_back(cells("{:g} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.4f}", row.wanted, xi, attractive,
                               clamped, exact, own, solved));
    figure.series[0].add(row.wanted, attractive);
    figure.series[1].add(row.wanted, clamped);
  }
  for (double e = 0.005; e <= 1.0; e += 0.005)
    figure.series[2].add(e, reference::restitution(reference::damping_ratio(e, reference::EndRule::attractive),
                                                   reference::EndRule::clamped));
  findings.table(table);
  findings.table(common);
  findings.figure(figure);
}

void check_solver_formulas(Findings& findings) {
  double inverse = 0.0, direct = 0.0, time = 0.0, depth = 0.0;
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    for (int i = 1; i <= 200; ++i) {
      const double e = i / 200.0;
      const double xi = reference::damping_ratio(e, same(rule));
      keep_largest(inverse, relative(talus::damping_ratio(e, rule), xi));
      keep_largest(direct, relative(talus::restitution(xi, rule), reference::restitution(xi, same(rule))));
      const LinearSpringDashpot law = dashpot_of(xi, 3e5, 0.7, rule);
      const auto events = reference::impact_events({law.stiffness, law.damping, 0.7, 2.5}, same(rule));
      keep_largest(time, relative(law.contact_time(0.7, 2.5), events.contact_time));
      keep_largest(depth, relative(law.largest_overlap(0.7, 2.5), events.largest_depth));
    }
  }
  // Near xi = 1, where the solver uses a series.
  double near_one = 0.0;
  for (const double off : {-0.99e-4, -3e-5, -1e-9, 0.0, 1e-9, 3e-5, 0.99e-4}) {
    const double xi = 1.0 + off, e = reference::restitution(xi, reference::EndRule::clamped);
    keep_largest(near_one, relative(talus::restitution(xi, EndRule::clamped), e));
    keep_largest(near_one, relative(talus::damping_ratio(e, EndRule::clamped),
                                    reference::damping_ratio(e, reference::EndRule::clamped)));
  }
  const double eps = 0x1p-52;
  findings.expect_round_off("solver's damping ratio and restitution near xi = 1, clamped, relative error", near_one,
                            0.0, 16.0 * eps, "as for the damping ratio at any e, with an exponent of 2");
  findings.expect_round_off({"formula_ratio", "solver's damping ratio for e = 0.005 ... 1, relative error"}, inverse,
                            0.0, 16.0 * eps,
                            "log, square root, acos, three products and the last bracket of two units of the root "
                            "search: 8 eps, times two for the worst of 400");
  findings.expect_round_off("solver's restitution for a damping ratio, relative error", direct, 0.0, 32.0 * eps,
                            "an exponent up to 5.3 amplifies its 4 roundings to 5.3 x 4 eps");
  double rebounds = 0.0;
  bool sticks = true;
  for (const double xi : {1.0, 1.25, 3.0}) {
    rebounds += talus::restitution(xi, EndRule::attractive);
    sticks = sticks && std::isinf(dashpot_of(xi, 3e5, 0.7, EndRule::attractive).contact_time(0.7, 2.5));
  }
  findings.expect_exact("solver's restitution of attractive contacts at and above critical damping", rebounds, 0.0,
                        "the overlap tends to zero and never reaches it: no rebound");
  findings.expect_true("solver's contact time of attractive contacts at and above critical damping is infinite", sticks,
                       "checked at 1, 1.25 and 3 times the critical damping");
  findings.expect_round_off("solver's contact time, relative error", time, 0.0, 32.0 * eps,
                            "xi from c, k, m with 4 roundings, amplified by xi^2/(1 - xi^2) <= 2.9 (attractive, e = "
                            "0.005), and as many again");
  findings.expect_round_off({"formula_overlap", "solver's largest overlap, relative error"}, depth, 0.0, 16.0 * eps,
                            "xi with 4 roundings in an exponent <= 3, and 4 more");
}

void check_step_advice(Findings& findings) {
  Table table{
      .name = "step_advice",
      .caption =
          "Step advised for a bound of the error of e (velocity Verlet, e = 0.5), and the largest error at 200 other "
          "phases.",
      .columns = {"end rule", "bound", "steps per contact", "largest error, advice", "largest error, 200 phases"}};
  double stated = 0.0;
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    for (const double bound : {1e-2, 1e-3}) {
      const LinearSpringDashpot law = dashpot_of(reference::damping_ratio(0.5, same(rule)), 1.0, 1.0, rule);
      const ImpactStep advice = advise_impact_step(law, 1.0, 1.0, bound, VelocityVerlet{});
      PhaseError errors;
      for (const double phase : golden_phases(200)) {
        Scene scene = scenes::bouncing_disc({.radius = 8.0, .gap = phase * advice.step, .speed = 1.0, .contact = law});
        scene.integrator = VelocityVerlet{};
        scene.plan = {advice.step, 10.0, 1.0, false};
        errors.add(follow_impact(scene, findings).restitution() - 0.5);
      }
      const std::string name =
          fmt::format("{}, bound {:g}", rule == EndRule::attractive ? "attractive" : "clamped", bound);
      findings.expect_truncation(
          {fmt::format("advised_step/{}/{:g}", rule == EndRule::attractive ? "attractive" : "clamped", bound),
           "largest error of e with the advised step at other phases, " + name},
          errors.max(), 0.0, bound, 1.0, "the requested bound");
      keep_largest(stated, errors.max() / advice.largest_error);
      const double time = reference::impact_events({1.0, law.damping, 1.0, 1.0}, same(rule)).contact_time;
      table.rows.push_back(cells("{} | {:g} | {:.0f} | {:.3e} | {:.3e}",
                                 rule == EndRule::attractive ? "attractive" : "clamped", bound, time / advice.step,
                                 advice.largest_error, errors.max()));
    }
  }
  findings.expect_between({"stated_error", "largest error of e at other phases over the stated one, largest"}, stated,
                          0.7, 1.0, "the stated error is 1.25 times that of 64 phases, of which these are near");
  findings.table(table);
}

void check_scene_calibration(Findings& findings) {
  Table table{.name = "scene_calibration",
              .caption =
                  "Contact of the pivoted cylinder calibrated by simulation to e = 0.5 (attractive rule, gravity on, "
                  "odeint's Dormand-Prince at 1e-11): the damping found, compared with that of the effective mass "
                  "$I_p/h^2$ and with Eq. 21 with the two masses.",
              .columns = {"k_n [lbf/ft]", "c found [lbf s/ft]", "c, effective mass", "difference", "c, two masses",
                          "difference", "e reached", "runs"}};
  const reference::PivotedCylinder problem{};
  Convergence differences;
  double missed = 0.0;
  for (const double stiffness : {1e5, 1.6e6, 2.56e7, 4.096e8, 1.6384e9, 6.5536e9}) {
    scenes::PivotedCylinder parameters{.rock_radius = problem.rock_radius, .contact = {}};
    parameters.contact = LinearSpringDashpot{stiffness, 0.0, EndRule::attractive};
    Scene scene = scenes::pivoted_cylinder(parameters);
    scene.integrator = make_integrator("odeint_dopri5", 1e-11);
    const double time = 3.2 * std::sqrt(13.0 / stiffness);
    scene.plan = {time / 200.0, 3.0 * time, time, false};
    const Calibration found = calibrate(scene, ContactId{0}, 0.5, 1e-9);
    const double formula = reference::pivoted_damping(problem, stiffness);
    const double particles = reference::particle_damping(problem, stiffness);
    differences.add(1.0 / std::sqrt(stiffness), std::abs(found.dissipation / formula - 1.0));
    keep_largest(missed, found.impact.restitution - 0.5);
    table.rows.push_back(cells("{:g} | {:.3f} | {:.3f} | {:+.3e} | {:.3f} | {:+.3e} | {:.10f} | {}", stiffness,
                               found.dissipation, formula, found.dissipation / formula - 1.0, particles,
                               found.dissipation / particles - 1.0, found.impact.restitution, found.runs));
  }
  findings.expect_truncation("error of e in the calibrated scene, target 0.5", missed, 0.0, 1e-9, 1.0,
                             "the requested tolerance");
  findings.expect_order(
      "order in 1/sqrt(k_n) of the difference between calibrated damping and that of the effective mass",
      differences.last(3), 0.985, 1.015,
      "the column turns during the contact by an angle proportional to the contact time; the next power is 1.1 % of it "
      "at the lowest of the three stiffnesses (224/sqrt(k_n), from the table's differences) and tilts the fit by less");
  findings.table(table);
}

}  // namespace talus::verification::problems
