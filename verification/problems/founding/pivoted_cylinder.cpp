#include <algorithm>
#include <cmath>

#include "verification/check/case.hpp"
#include "verification/problems/founding/pivoted_ledger_findings.hpp"
#include "verification/problems/founding/pivoted_report_of_1993.hpp"
#include "verification/problems/founding/pivoted_step_findings.hpp"
#include "verification/problems/founding/pivoted_swing.hpp"
#include "verification/reference/pivoted_cylinder.hpp"
#include "verification/study/pivoted_impact.hpp"

namespace talus::verification::problems {
namespace {

const reference::PivotedCylinder problem{};
constexpr double softest = 4e4;                         // [lbf/ft]
constexpr double stiffest = softest * 4096.0 * 1024.0;  // [lbf/ft], 4^11 times that: rigid to 4e-6

/// How far the soft contact's answers are from the rigid ones, and from the soft reference's, over k_n.
struct Approach {
  Convergence column, rock, swing;  ///< distance of v1 [ft/s], V1 [ft/s] and the largest angle [rad] to the rigid ones
  Series soft_column{.label = "v1 [ft/s], soft reference", .style = Style::lines};
  Series soft_rock{.label = "V1 [ft/s], soft reference", .style = Style::lines};
  Series soft_swing{.label = "largest angle [rad], soft reference", .style = Style::lines};
  double apart{};    ///< largest distance of solver and soft reference [ft/s]
  double carried{};  ///< of which the interpolated end explains so much
  AfterImpact last;  ///< at the largest stiffness
};

/// Adds one stiffness to the comparison of `a` with the soft reference.
void add_soft_reference(Approach& a, const PivotedRun& run, const reference::PivotedImpact& rigid, double angle) {
  const reference::PivotedSoftImpact soft = reference::soft_impact(problem, contact_of(run));
  const double compliance = 1.0 / std::sqrt(run.stiffness);
  for (Series* series : {&a.soft_column, &a.soft_rock, &a.soft_swing})
    series->x.push_back(compliance);
  a.soft_column.y.push_back(std::abs(soft.column_speed - rigid.column));
  a.soft_rock.y.push_back(std::abs(soft.at_end.rock_vx - rigid.rock));
  a.soft_swing.y.push_back(std::abs(soft.largest_angle - angle));
  // The end's time is interpolated: off by at most dt^2 d''/(8 d') = dt^2 2 xi w/8. The weight slows the column by
  // h w0^2 theta.
  const double late = std::pow(converged_interval, 2) * damping_ratio_of(run) / (4.0 * frequency_of(run));
  a.carried = std::max(a.carried, late * problem.mass * problem.gravity * std::pow(0.5 * problem.length, 2) /
                                      reference::inertia_about_pin(problem) * soft.at_end.angle);
  a.apart =
      std::max({a.apart, std::abs(a.last.column - soft.column_speed), std::abs(a.last.rock - soft.at_end.rock_vx)});
}

Approach approach(const reference::PivotedImpact& rigid, double angle, Findings& findings, const Setup& setup) {
  Approach a;
  for (double k = setup.coarse ? stiffest / 16.0 : softest; k <= stiffest; k *= setup.coarse ? 16.0 : 4.0) {
    const PivotedRun run{.stiffness = k};
    a.last = converged_impact(run, setup, findings);
    const double compliance = 1.0 / std::sqrt(k);
    a.column.add(compliance, std::abs(a.last.column - rigid.column));
    a.rock.add(compliance, std::abs(a.last.rock - rigid.rock));
    a.swing.add(compliance, std::abs(a.last.largest_angle - angle));
    if (!setup.coarse) add_soft_reference(a, run, rigid, angle);
  }
  return a;
}

/// By which power of the stiffness the answers approach, and that the soft reference does the same.
void check_approach(const Approach& a, Findings& findings) {
  const std::string why =
      "the column turns during the contact by an angle that goes with the contact time; the next power is at most "
      "320 over sqrt(k_n) of it, .6 % at the softest of the four stiffnesses, and tilts the fit by less";
  findings.expect_order("v1 to the rigid limit, power of 1/sqrt(k_n)", a.column.last(4), 0.994, 1.006, why);
  findings.expect_order("V1 to the rigid limit, power of 1/sqrt(k_n)", a.rock.last(4), 0.994, 1.006, why);
  findings.expect_order("largest angle to the rigid limit, power of 1/sqrt(k_n)", a.swing.last(4), 0.994, 1.006, why);
  findings.expect("largest distance to the soft reference over k_n", a.apart, 0.0,
                  Tolerance::truncation(a.carried, 1.0,
                                        "Dormand-Prince at 1e-12 leaves 1e-10; v1 is carried back to an end whose time "
                                        "is interpolated, to second order of the samples' interval"),
                  "ft/s");
  findings.figure({.name = "rigid_limit",
                   .title = "Approach to the rigid impact",
                   .caption = "Distance of the soft contact's answers from the rigid ones: the solver (points) and the "
                              "soft reference (lines). Where a curve dips its difference changes sign.",
                   .x = {.label = "1/sqrt(k_n)", .unit = "sqrt(ft/lbf)", .log = true},
                   .y = {.label = "distance to the rigid impact", .unit = "ft/s, rad", .log = true},
                   .series = {{"v1 [ft/s], solver", a.column.steps(), a.column.errors(), Style::points},
                              a.soft_column,
                              {"V1 [ft/s], solver", a.rock.steps(), a.rock.errors(), Style::points},
                              a.soft_rock,
                              {"largest angle [rad], solver", a.swing.steps(), a.swing.errors(), Style::points},
                              a.soft_swing},
                   .slopes = {{1.0, a.column.steps().back(), 5.0 * a.column.errors().back(), "1/sqrt(k_n)"}}});
}

/// Rigid impact: the soft contact's answers at a stiffness where a sixteenth of it is four times as far away.
void check_rigid_limit(Findings& findings, const Setup& setup) {
  const reference::PivotedImpact rigid = reference::rigid_impact(problem);
  const double angle = reference::corrected_largest_angle(problem, rigid.angular);
  const Approach a = approach(rigid, angle, findings, setup);
  const auto stiff = [](const Convergence& c, bool coarse) {
    return Tolerance::model(c.errors()[c.size() - (coarse ? 2 : 3)] / 4.0 * 1.2,
                            "the contact's softness: a quarter of the distance found at a sixteenth of the "
                            "stiffness, and a fifth more");
  };
  findings.expect("v1, rigid limit (Eq. 28 corrected)", a.last.column, rigid.column, stiff(a.column, setup.coarse),
                  "ft/s");
  findings.expect("V1, rigid limit", a.last.rock, rigid.rock, stiff(a.rock, setup.coarse), "ft/s");
  findings.expect("largest angle, rigid limit (Eq. 30 corrected)", a.last.largest_angle, angle,
                  stiff(a.swing, setup.coarse), "rad");
  if (!setup.coarse) check_approach(a, findings);
}

/// Restitution that each dashpot gives.
void check_effective_restitution(Findings& findings, const Setup& setup) {
  for (const Dashpot dashpot : {Dashpot::pivoted_mass, Dashpot::two_masses}) {
    const bool pivoted = dashpot == Dashpot::pivoted_mass;
    const auto restitution_at = [&](double stiffness) {
      const AfterImpact after = converged_impact({.stiffness = stiffness, .dashpot = dashpot}, setup, findings);
      return (after.column - after.rock) / problem.approach_speed;
    };
    const double exact = reference::restitution_of(problem, contact_of({.stiffness = stiffest, .dashpot = dashpot}));
    const double softer = std::abs(restitution_at(stiffest / 16.0) - exact);
    // The right dashpot's distance bounds both: a faulty one may not widen it.
    findings.expect(pivoted ? "effective e, Eq. 21 with the pivoted mass" : "effective e, Eq. 21 with the two masses",
                    restitution_at(stiffest), exact,
                    Tolerance::model(std::min(softer, 5e-5) / 4.0 * 1.2,
                                     "the contact's softness: a quarter of the distance at a sixteenth of the "
                                     "stiffness, and a fifth more"));
  }
}

void run(Findings& findings, const Setup& setup) {
  check_rigid_limit(findings, setup);
  check_effective_restitution(findings, setup);
  check_step(findings, setup);
  check_swing(findings, setup);
  check_ledger(findings, setup);
  if (!setup.coarse) check_report_of_1993(findings);
}

}  // namespace

Case pivoted_cylinder() {
  return {.id = "pivoted_cylinder",
          .title = "Pivoted cylinder hit by a rock",
          .family = "founding problems",
          .requirements = {{"Eq. 4", {"swing"}},
                           {"Eq. 17", {"production run", "soft reference", "overlap"}},
                           {"Eq. 19", {"attractive", "clamped"}},
                           {"Eq. 20", {"overlap", "angular momentum about the pin"}},
                           {"Eq. 21", {"effective e"}},
                           {"Eq. 23", {"order of v1", "steps per contact"}},
                           {"Eq. 24", {"order of v1", "steps per contact"}},
                           {"Eq. 28",
                            {"v1, rigid limit", "v1 to the rigid limit", "Eq. 28 as printed", "v1 of the solver",
                             "v1 as the report prints it"}},
                           {"Eq. 29", {"order of the swing", "largest angle against elliptic functions"}},
                           {"Eq. 30",
                            {"largest angle, rigid limit", "largest angle by Eq. 30 as printed",
                             "largest angle of the swing"}},
                           {"law.linear_spring_dashpot", {"order of v1", "overlap", "effective e"}},
                           {"end_rule.attractive", {"attractive"}},
                           {"end_rule.clamped", {"clamped"}},
                           {"method.resultant", {"production run"}},
                           {"method.nodes", {"as the report prints it"}},
                           {"shape.circle", {"production run", "effective e"}},
                           {"shape.rectangle", {"production run", "effective e"}},
                           {"integrator.central_difference", {"order of v1", "steps per contact"}},
                           {"integrator.velocity_verlet", {"order of the swing", "angular momentum about the pin"}},
                           {"integrator.odeint_dopri5", {"to the rigid limit", "effective e"}},
                           {"pair.circle.rectangle", {"production run", "effective e"}}},
          .main_checks = {"v1, rigid limit (Eq. 28 corrected)", "V1, rigid limit",
                          "largest angle of the swing, production run", "effective e, Eq. 21 with the pivoted mass",
                          "effective e, Eq. 21 with the two masses"},
          .source = "Mustoe & Huttelmaier 1993, section 5, validation problem 2, Eqs. 28-30, Figs. 9-11",
          .faults = {{"two_masses", "Eq. 21 with the column's mass as if it were a particle",
                      "effective e, Eq. 21 with the pivoted mass"},
                     {"column_mass_halved", "the column has half its mass", "v1, rigid limit (Eq. 28 corrected)"},
                     {"clamped", "the contact never pulls", "rms error of v1, 64 steps per contact, attractive"},
                     {"gravity_doubled", "twice the weight's moment, as in Eq. 30 as printed",
                      "largest angle of the swing, production run"},
                     {"euler_cromer", "the swing's velocities half a step from its angles",
                      "order of the swing after the impact"},
                     {"rk4", "a method that does not conserve angular momentum exactly",
                      "angular momentum about the pin, largest relative change"}},
          .run = run};
}

}  // namespace talus::verification::problems
