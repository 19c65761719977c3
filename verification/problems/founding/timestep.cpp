#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/check/case.hpp"
#include "verification/problems/founding/commensurate_findings.hpp"
#include "verification/problems/founding/smooth_motion_findings.hpp"
#include "verification/problems/founding/struck_scenes.hpp"
#include "verification/reference/restitution.hpp"
#include "verification/study/leapfrog_impact_error.hpp"

namespace talus::verification::problems {

Case timestep();

namespace {

constexpr double pi = std::numbers::pi;
constexpr double wall_damping = 0.2;

/// One curve of a figure and the checks on it.
struct Study {
  std::string scene;  ///< named in checks
  PhasedImpact impact;
  std::string method;          ///< in make_integrator
  std::vector<double> counts;  ///< N
  Offset offset;
  int order;
  double constant;  ///< predicted rms relative error times N^order
  double admitted;  ///< relative deviation of the constant that `why` explains
  std::string why;
  double tilt;  ///< of the order fitted, either way, that `tilt_why` explains
  std::string tilt_why;
};

Series study(Findings& findings, const Study& s) {
  const Sweep swept = sweep(s.impact, make_integrator(s.method), s.counts, s.offset);
  findings.expect_order(fmt::format("{}: order of {}", s.scene, s.method), swept.rms, s.order - s.tilt,
                        s.order + s.tilt,
                        "a force that jumps has order 1, one that kinks order 2, whatever the method; " + s.tilt_why);
  const double measured = swept.rms.errors().back() * std::pow(swept.steps.back(), s.order);
  findings.expect(fmt::format("{}: rms constant of {}", s.scene, s.method), measured, s.constant,
                  Tolerance::model(s.admitted, s.why).relative());
  double evaluations = 0.0;
  for (const double e : swept.evaluations)
    evaluations += e * static_cast<double>(fewest_phases);
  findings.count(std::lround(evaluations));
  return {.label = s.scene + ", " + s.method,
          .x = swept.rms.steps(),
          .y = swept.rms.errors(),
          .style = s.method == "central_difference" ? Style::points : Style::linespoints};
}

std::vector<double> counts_of(const Setup& setup, double first, int decades_and_more) {
  std::vector<double> counts;
  for (int i = 0; i < (setup.coarse ? 3 : decades_and_more); ++i)
    counts.push_back(first * std::pow(4.0, i));
  return counts;
}

constexpr const char* one_offset =
    "second-order prediction; 64 phases integrate the fourth-order polynomial to 1e-3, and the next order is below "
    "that at the finest step";
constexpr const char* own_offsets =
    "first-term prediction for phases of onset and release that are spread evenly and independently; 64 pairs stand "
    "for that square to about 3 %";

/// Why the line through six sweeps, from 8 to 8192 steps, may be tilted by .33 of what the order between the first two
/// is off.
std::string pair_why(double off) {
  return fmt::format(
      "between 8 and 32 steps the next order makes it {} off, and a quarter of that from one pair to the next: the "
      "line through six is tilted by .22 of it; half of that again is admitted for the orders after, either way",
      off);
}

/// The disc on the wall by one method, undamped and damped: two curves, and the lines predicted for them.
void study_wall(const std::string& method, Figure& figure, Findings& findings, const Setup& setup) {
  const bool rk4 = method == "rk4";
  // The fewest steps tilt most: three sweeps have to do when coarse, and begin at 32.
  const std::vector<double> wall_counts = counts_of(setup, setup.coarse ? 32.0 : 8.0, 6);
  const PhasedImpact elastic = struck_disc({});
  const PhasedImpact damped = struck_disc({.damping_ratio = wall_damping, .without_dashpot = setup.has("dashpot_off")});
  const double w_tc = 2.0 * std::acos(wall_damping) / std::sqrt(1.0 - wall_damping * wall_damping);
  const double elastic_constant = rk4 ? rk4_elastic_constant(common_offset) : leapfrog_elastic_constant(common_offset);
  const double damped_constant =
      w_tc * (rk4 ? rk4_damped_constant(wall_damping, reference::EndRule::clamped)
                  : leapfrog_impact_error(wall_damping, reference::EndRule::clamped).restitution);
  // Leapfrog, undamped: its period shifts the offset by -pi^2/(24 N), the error by the share -.411/N. Others
  // measured.
  const double elastic_pair = rk4 ? 0.0033 : 0.0277;
  const double damped_pair = rk4 ? 0.0045 : 0.0256;
  const Offset offset = setup.has("commensurate_step") ? Offset::none : Offset::common;
  figure.series.push_back(
      study(findings, {"disc on a wall, undamped", elastic, method, wall_counts, offset, 2, elastic_constant,
                       setup.coarse ? 0.004 : 0.001, one_offset, 0.33 * elastic_pair, pair_why(elastic_pair)}));
  figure.series.push_back(study(findings, {"disc on a wall, damped", damped, method, wall_counts, Offset::own, 1,
                                           damped_constant, setup.coarse ? 0.004 : 0.001,
                                           "first-order prediction; its next order is below 1e-3 at the finest step",
                                           0.33 * damped_pair, pair_why(damped_pair)}));
  if (method == "central_difference") return;
  // Labels stand at the anchors: those of rk4 apart from those of velocity Verlet.
  const double anchor = rk4 ? 4e-4 : 2e-2;
  figure.slopes.push_back(
      {2.0, anchor, elastic_constant * anchor * anchor, fmt::format("{:.3f} h^2", elastic_constant)});
  figure.slopes.push_back({1.0, anchor, damped_constant * anchor, fmt::format("{:.3f} h", damped_constant)});
}

void check_wall(Findings& findings, const Setup& setup) {
  Figure figure{.name = "wall",
                .title = "A disc on a wall",
                .caption =
                    "Root mean square over 64 onset phases of the relative error of the exit speed, against the "
                    "step in contact times: three decades. Undamped: order 2, RK4 included. Damped ($\\xi$ = 0.2, "
                    "clamped): order 1 for all. The points of central difference lie on velocity Verlet's lines: "
                    "the two differ in what they report, not in where they go. Dashed: the predicted errors, "
                    "constants included.",
                .x = {"step / contact time", "1", true},
                .y = {"rms relative error", "1", true}};
  for (const char* method : {"velocity_verlet", "rk4", "central_difference"}) {
    if (setup.coarse && std::string_view{method} != "velocity_verlet") continue;
    study_wall(method, figure, findings, setup);
  }
  if (!setup.coarse) findings.figure(figure);
}

/// The particle on its cables or the column by one method, undamped and damped: two curves, and the lines predicted for
/// them.
void study_case(bool cables, const std::string& method, Figure& figure, Findings& findings, const Setup& setup) {
  const bool rk4 = method == "rk4";
  const double xi = reference::damping_ratio(0.5, reference::EndRule::attractive);
  const double w_tc = pi / std::sqrt(1.0 - xi * xi);
  // The struck body's speed is proportional to 1 + e: a relative error r of e is one of e r/(1 + e) of the speed.
  const double share = 0.5 / 1.5;
  const double scatter = setup.coarse ? 0.04 : 0.0104;
  const std::string scatter_why =
      "64 pairs of phases stand for all to 3 % in each point: the line through six, a factor 4 apart, then scatters by "
      ".03/(ln 4 sqrt(17.5)) = .0052, and two standard deviations are admitted (.04 with three points)";
  const std::string scene = cables ? "two cables" : "pivoted cylinder";
  const auto struck = [&](double e) {
    return cables ? struck_cables(e, setup.has("mass_halved") ? 0.5 : 1.0) : struck_column(e);
  };
  const double damped_constant = share * w_tc *
                                 (rk4 ? rk4_damped_constant(xi, reference::EndRule::attractive)
                                      : leapfrog_impact_error(xi, reference::EndRule::attractive).restitution);
  figure.series.push_back(study(findings, {scene + ", damped", struck(0.5), method, counts_of(setup, 8.0, 6),
                                           Offset::own, 1, damped_constant, 0.08, own_offsets, scatter, scatter_why}));
  if (method == "central_difference") return;
  const double elastic_constant = 0.5 * (rk4 ? rk4_elastic_constant() : leapfrog_elastic_constant());
  figure.series.push_back(study(findings, {scene + ", undamped", struck(1.0), method, counts_of(setup, 8.0, 6),
                                           Offset::own, 2, elastic_constant, 0.04, own_offsets, scatter, scatter_why}));
  if (rk4) return;
  figure.slopes = {{2.0, 1e-2, elastic_constant * 1e-4, fmt::format("{:.3f} h^2", elastic_constant)},
                   {1.0, 1e-2, damped_constant * 1e-2, fmt::format("{:.3f} h", damped_constant)}};
}

void check_cases(Findings& findings, const Setup& setup) {
  for (const bool cables : {true, false}) {
    if (setup.coarse && !cables) continue;
    Figure figure{
        .name = cables ? "two_cables" : "pivoted_cylinder",
        .title = cables ? "Case 1, the particle between two cables" : "Case 2, the pivoted cylinder",
        .caption = fmt::format("rms over 64 phases of the relative error of the {} after the impact, against "
                               "the soft-contact reference: e = 1 (order 2) and e = 0.5 (order 1). Dashed: "
                               "predicted for velocity Verlet; the points of central difference lie on its line.",
                               cables ? "particle's velocity" : "column's angular velocity"),
        .x = {"step / contact time", "1", true},
        .y = {"rms relative error", "1", true}};
    for (const char* method : {"velocity_verlet", "rk4", "central_difference"}) {
      if (setup.coarse && std::string_view{method} != "velocity_verlet") continue;
      study_case(cables, method, figure, findings, setup);
    }
    if (!setup.coarse) findings.figure(figure);
  }
}

void run(Findings& findings, const Setup& setup) {
  check_wall(findings, setup);
  check_cases(findings, setup);
  check_smooth(findings, setup);
  if (setup.coarse) return;
  check_commensurate(findings);
  check_gain(findings);
  check_phases(findings);
}

}  // namespace

Case timestep() {
  return {
      .id = "timestep",
      .title = "Error against time step: contacts, smooth motion",
      .family = "founding problems",
      .requirements = {{"Eq. 17", {", damped: order", "undamped: order"}},
                       {"Eq. 23", {"order of central_difference", "order of velocity_verlet"}},
                       {"Eq. 24", {"order of central_difference", "order of velocity_verlet"}},
                       {"B1", {"disc on a wall, undamped"}},
                       {"law.linear_spring_dashpot", {", damped: order", ", damped: rms constant"}},
                       {"law.tension_only", {"particle on cables"}},
                       {"end_rule.attractive", {"two cables, damped", "pivoted cylinder, damped"}},
                       {"end_rule.clamped", {"disc on a wall, damped"}},
                       {"method.resultant", {", damped: order"}},
                       {"integrator.central_difference", {"central_difference"}},
                       {"integrator.velocity_verlet", {"velocity_verlet"}},
                       {"integrator.euler_cromer", {"euler_cromer"}},
                       {"integrator.rk4", {"rk4"}},
                       {"shape.circle", {"disc on a wall"}},
                       {"shape.rectangle", {"pivoted cylinder"}},
                       {"shape.half_plane", {"disc on a wall"}},
                       {"pair.circle.half_plane", {"disc on a wall"}},
                       {"pair.circle.rectangle", {"pivoted cylinder"}},
                       {"pair.circle.circle", {"two cables"}}},
      .main_checks = {"disc on a wall, undamped: order of velocity_verlet", "disc on a wall, undamped: order of rk4",
                      "disc on a wall, damped: order of velocity_verlet",
                      "commensurate steps: false order of velocity_verlet", "commensurate steps: false order of rk4"},
      .source =
          "Mustoe & Huttelmaier 1993, section 5, validation problems 1 and 2, Eqs. 17, 23, 24; error constants derived "
          "here",
      .faults = {{"commensurate_step", "the contact time is a whole number of steps",
                  "disc on a wall, undamped: order of velocity_verlet"},
                 {"dashpot_off", "the wall's dashpot is left out", "disc on a wall, damped: order of velocity_verlet"},
                 {"mass_halved", "the particle on the cables has half its mass",
                  "two cables, damped: order of velocity_verlet"},
                 {"euler_cromer_for_verlet", "Euler-Cromer in place of velocity Verlet",
                  "particle on cables: order of velocity_verlet"}},
      .run = run};
}

}  // namespace talus::verification::problems
