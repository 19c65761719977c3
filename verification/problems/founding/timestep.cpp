#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/scenes/two_cable.hpp"
#include "verification/problems/founding/struck_scenes.hpp"
#include "verification/reference/cables/two_cable.hpp"
#include "verification/reference/impacts/pivoted_cylinder.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/common_formula.hpp"
#include "verification/study/impacts/leapfrog_impact_error.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::timestep {
namespace {

Integrator verlet(const Setup& setup) {
  return make_integrator(setup.has("euler_cromer_for_verlet") ? "euler_cromer" : "velocity_verlet");
}

/// A smooth motion after an impact, and its exact state at the end.
struct SmoothMotion {
  std::string name;
  Scene scene;
  double duration;
  double position, velocity;  ///< at the end, exact
  double scale, start;        ///< largest position; velocity at the start, which is the largest
};

SmoothMotion particle_on_cables() {
  const reference::TwoCable problem;
  const double v1 = reference::rigid_impact(problem).particle;
  const reference::TwoCableMotion motion{problem, v1};
  Scene cables = scenes::two_cable({.contact = LinearSpringDashpot{1.0, 0.0, EndRule::attractive}});
  cables.initial.q[2] = -100.0;  // the striker is out of reach
  cables.initial.v = {v1, 0.0, 0.0, 0.0};
  const double duration = 1.3 * motion.time_to_turning();
  const auto end = motion.at(duration);
  return {"particle on cables", cables, duration, end.position, end.velocity, motion.largest_distance(), v1};
}

SmoothMotion column_swing() {
  const reference::PivotedCylinder problem;
  const double w1 = reference::rigid_impact(problem).angular;
  const auto motion = reference::swing(problem, w1);
  Scene column = scenes::pivoted_cylinder({.rock_radius = problem.rock_radius,
                                           .gravity = problem.gravity,
                                           .contact = LinearSpringDashpot{1.0, 0.0, EndRule::attractive}});
  column.initial.q[1] = -100.0;  // the rock is out of reach
  column.initial.v = {w1, 0.0, 0.0, 0.0};
  const double duration = 0.325 * motion.period();
  const auto end = motion.at(duration);
  return {"column's swing", column, duration, end.angle, end.rate, motion.amplitude(), w1};
}

/// Checks the order of one method on one motion, and draws its curve and, if required, the slope for comparison.
void study(const SmoothMotion& motion, const std::string& method, bool with_slope, Figure& figure, Findings& findings,
           const Setup& setup) {
  const auto claim = findings.in("integrator." + method), group = findings.in(motion.name);
  const int order = integrator_traits(method).order;
  const bool first = order == 1, fourth = order == 4;
  const Integrator integrator = method == "velocity_verlet" ? verlet(setup) : make_integrator(method);
  Convergence gated;
  Series series{.label = motion.name + ", " + method};
  for (long steps = 16; steps <= (setup.coarse ? 4096 : 65536); steps *= 2) {
    const RunEnd end = run_steps(motion.scene, integrator, motion.duration / static_cast<double>(steps), steps);
    series.add(1.0 / static_cast<double>(steps), std::hypot((end.state.q[0] - motion.position) / motion.scale,
                                                            (end.state.v[0] - motion.velocity) / motion.start));
    if (steps >= (fourth ? 32 : 64) && !(fourth && steps > 512)) gated.add(series.x.back(), series.y.back());
    if (series.y.back() < 1e-15) break;
  }
  const double admitted = fourth ? 0.03 : first ? 7.5e-4 : setup.coarse ? 1.1e-4 : 5e-5;
  const char* why =
      fourth
          ? "smooth motion: the declared order. Between 16 and 32 steps it is off by 0.084 (column: 0.006), by half as "
            "much after each doubling, which tilts the line from 32 to 512 steps by 0.019: 1.5 times this is allowed"
      : first
          ? "smooth motion: the declared order. Between 32 and 64 steps it is off by 0.0068 (particle: 0.0041), by "
            "half as much after each doubling, which tilts the line from 64 steps on by 5e-4: 1.5 times this is allowed"
          : "smooth motion: the declared order. Between 32 and 64 steps it is off by 0.0017 (column: 0.0006), by a "
            "quarter as much after each doubling, which tilts the line from 64 steps on by 3.1e-5 (to 4096 only: "
            "7e-5): 1.5 times this is allowed";
  const bool leapfrog = method == "velocity_verlet" || method == "central_difference";
  findings.expect_order(
      {leapfrog ? "leapfrog_orders" : "other_orders", fmt::format("{}: order of {}", motion.name, method)}, gated,
      order - admitted, order + admitted, why);
  if (with_slope && !integrator_traits(method).is_staggered)
    figure.slopes.push_back({static_cast<double>(order), series.x[3], 2.0 * series.y[3], fmt::format("h^{}", order)});
  figure.series.push_back(series);
}

/// The declared order of each method on the smooth motions after the impacts of cases 1 and 2. Fault
/// `euler_cromer_for_verlet`.
void check_smooth(Findings& findings, const Setup& setup) {
  Figure figure{
      .name = "smooth",
      .title = "Smooth motion after the impacts",
      .caption =
          "Error of position and velocity (each over its largest value, added in quadrature) after 1.3 quarter periods "
          "of the particle on its cables and of the column: the declared orders, down to round-off.",
      .x = {"step / duration", "1", true},
      .y = {"relative error", "1", true}};
  for (const bool on_cables : {true, false}) {
    if (setup.coarse && !on_cables) continue;
    const SmoothMotion motion = on_cables ? particle_on_cables() : column_swing();
    for (const char* method : {"velocity_verlet", "central_difference", "rk4", "euler_cromer"}) {
      if (setup.coarse && std::string_view{method} != "velocity_verlet") continue;
      study(motion, method, on_cables, figure, findings, setup);
    }
  }
  if (!setup.coarse) findings.figure(figure);
}

constexpr double pi = std::numbers::pi;

/// Speed after the contact over that before it, by the exact map of the leapfrog: eta = w h, the touch at the fraction
/// `phase` of a step.
double leapfrog_exit(double eta, double phase) {
  const double turn = 2.0 * std::asin(0.5 * eta);  // rotation of the leapfrog per step
  const double theta = 1.0 - phase;
  // Angle of the state at its first point in contact.
  const double start = std::atan2(eta * theta * std::sqrt(1.0 - 0.25 * eta * eta), 1.0 - 0.5 * eta * eta * theta);
  const double inside = std::floor((pi - start) / turn);  // steps after the first point with positive overlap
  const double q = std::sin(start + inside * turn);       // last overlap in contact over the amplitude
  const double p = std::cos(start + inside * turn);       // velocity there, over the amplitude, < 0
  const double amplitude = std::sqrt(1.0 - eta * eta * theta * (1.0 - theta));
  const double depth = q * amplitude / std::sqrt(1.0 - 0.25 * eta * eta);
  return -(p * amplitude - 0.5 * eta * depth);
}

/// Steps that divide the contact time show an order that the method does not have: false orders, and a figure.
void check_commensurate(Findings& findings) {
  const PhasedImpact elastic = struck_disc({});
  Table common =
      common_formula("order",
                     "**Order of a method, from steps that divide the contact time.** The orders fitted to $t_c/h = N$ "
                     "= 16, 32, ... hold for no other steps, because the errors of onset and release cancel. Exact: 2 "
                     "for a force with a kink, for every method. Solver: the same fit with $t_c/h = N + 0.382$.");
  Figure figure{
      .name = "commensurate",
      .title = "False order with steps that divide the contact time",
      .caption =
          "The same undamped disc with t_c/h an integer N, and with N + 0.382. With an integer the errors of onset and "
          "release cancel for every phase, so that velocity Verlet seems to have order 3, RK4 order 4.",
      .x = {"step / contact time", "1", true},
      .y = {"rms relative error", "1", true}};
  for (const char* method : {"velocity_verlet", "rk4"}) {
    const bool fourth = integrator_traits(method).order == 4;
    const std::vector<double> counts = doublings(16.0, fourth ? 6 : 8);
    const Sweep hidden = sweep(elastic, make_integrator(method), counts, Offset::none);
    const Sweep honest = sweep(elastic, make_integrator(method), counts, Offset::common);
    const int seen = fourth ? 4 : 3;
    const auto claim = findings.in(fmt::format("integrator.{}", method));
    findings.expect_order(fmt::format("commensurate steps: false order of {}", method), hidden.rms, seen - 0.1,
                          seen + 0.1,
                          "onset and release errors of second order are equal and opposite for every phase; the "
                          "remainder is of the next order");
    const double fitted = hidden.rms.fit().order;
    common.rows.push_back(cells("`{}`, undamped disc on a wall | {:.3f} | 2 | {:+.3f} | {:.3f}", method, fitted,
                                fitted - 2.0, honest.rms.fit().order));
    figure.series.push_back({fmt::format("{}, t_c/h = N", method), hidden.rms.steps(), hidden.rms.errors()});
    figure.series.push_back({fmt::format("{}, t_c/h = N + 0.382", method), honest.rms.steps(), honest.rms.errors()});
    figure.slopes.push_back(
        {static_cast<double>(seen), hidden.rms.steps()[3], 0.5 * hidden.rms.errors()[3], fmt::format("h^{}", seen)});
    if (fourth) continue;
    findings.expect("commensurate steps: rms error constant of velocity_verlet",
                    hidden.rms.errors().back() * std::pow(hidden.steps.back(), 3.0),
                    std::pow(pi, 4.0) / (48.0 * std::numbers::sqrt3),
                    Tolerance::model(1e-3,
                                     "the leapfrog's period, too short by the fraction eta^2/24, acts as an offset of "
                                     "-pi^2/(24 N) steps; the next order is below 1e-3 at the smallest step")
                        .relative());
    figure.slopes.push_back({2.0, honest.rms.steps()[3], 2.0 * honest.rms.errors()[3], "h^2"});
  }
  findings.table(common);
  findings.figure(figure);
}

/// Compares gain and loss of speed in an undamped impact, at steps up to 2/w, with the exact map of the leapfrog: a
/// check and a table.
void check_gain(Findings& findings) {
  Table table = common_formula(
      "gain",
      "**Stable below $h = 2/\\omega$.** This is the limit of a spring that always acts. A contact is unilateral: each "
      "impact begins and ends within a step, and even far below the limit an undamped disc leaves the wall faster or "
      "slower than it arrived. $|v'/v|$, maximum over 64 phases; exact: the leapfrog's map.");
  table.columns.insert(table.columns.begin() + 3, "exact minimum");
  const PhasedImpact elastic = struck_disc({});
  double worst = 0.0;
  for (const double eta : {0.3, 0.7, 1.2, 1.6, 1.9}) {
    const std::vector<double> counts{pi / eta - common_offset};
    const Sweep swept = sweep(elastic, make_integrator("velocity_verlet"), counts, Offset::common);
    const std::vector<double> phases = even_phases(fewest_phases);
    double largest = 0.0, smallest = 1.0, seen = 0.0;
    for (std::size_t i = 0; i < phases.size(); ++i) {
      const double exact = leapfrog_exit(eta, phases[i]), solver = 1.0 + swept.by_phase.front()[i];
      largest = std::max(largest, exact);
      smallest = std::min(smallest, exact);
      seen = std::max(seen, solver);
      keep_largest(worst, solver - exact);
    }
    table.rows.push_back(cells("$\\omega h$ = {:g} | 1 | {:.3f} | {:.3f} | {:+.1f} % | {:.3f}", eta, largest, smallest,
                               100.0 * (1.0 / largest - 1.0), seen));
  }
  findings.expect_round_off("exit speed at w h = 0.3 ... 1.9, largest error against the exact map over 64 phases",
                            worst, 0.0, 64.0 * 2.2e-16,
                            "the map is exact: at most 20 steps, each with three roundings of numbers up to 2.6; the "
                            "overlap is a difference of lengths a few times larger");
  findings.table(table);
}

/// Compares each single onset phase at one coarse step with the exact map of the leapfrog: a check and a figure.
void check_phases(Findings& findings) {
  const double count = 16.0;
  const std::vector<double> counts{count};
  const Sweep swept = sweep(struck_disc({}), make_integrator("velocity_verlet"), counts, Offset::common);
  const double eta = pi / (count + common_offset);
  Series solver{
      .label = "solver", .x = even_phases(fewest_phases), .y = swept.by_phase.front(), .style = Style::points};
  const Series theory =
      curve("exact map of the leapfrog", solver.x, [&](double phase) { return leapfrog_exit(eta, phase) - 1.0; });
  const double worst = std::abs(worst_error(theory.y, solver.y));
  findings.expect_round_off("exit speed at 16.4 steps per contact, largest error against the exact map over 64 phases",
                            worst, 0.0, 64.0 * 2.2e-16,
                            "the map is exact: 20 steps, each with three roundings of a number below 1");
  findings.figure(
      {.name = "phases",
       .title = "Error against onset phase",
       .caption = "Relative error of the exit speed for each onset phase at 16.4 steps per contact, and the closed "
                  "form of the leapfrog's map. A single run can have any of these errors, including zero.",
       .x = {"onset phase", "1"},
       .y = {"relative error of the exit speed", "1"},
       .series = {theory, solver}});
}

constexpr double wall_damping = 0.2;

/// One curve of a figure and its checks.
struct Study {
  std::string scene;  ///< name in the checks
  PhasedImpact impact;
  std::string method;          ///< name for make_integrator()
  std::vector<double> counts;  ///< N
  Offset offset;
  int order;
  double constant;  ///< predicted rms relative error times N^order
  double admitted;  ///< relative deviation of the constant that `why` explains
  std::string why;
  double tilt;  ///< deviation of the fitted order, in either direction, that `tilt_why` explains
  std::string tilt_why;
};

Series study(Findings& findings, const Study& s) {
  const auto claim = findings.in("integrator." + s.method), scene = findings.in(s.scene);
  const auto impacts = findings.in(s.order == 1 ? "damped_impacts" : "undamped_impacts");
  const Sweep swept = sweep(s.impact, make_integrator(s.method), s.counts, s.offset);
  findings.expect_order(
      {s.method == "rk4" ? "other_orders" : "leapfrog_orders", fmt::format("{}: order of {}", s.scene, s.method)},
      swept.rms, s.order - s.tilt, s.order + s.tilt,
      "a force with a jump gives order 1, a force with a kink order 2, for every method; " + s.tilt_why);
  const double measured = swept.rms.errors().back() * std::pow(swept.steps.back(), s.order);
  findings.expect(fmt::format("{}: rms error constant of {}", s.scene, s.method), measured, s.constant,
                  Tolerance::model(s.admitted, s.why).relative());
  double evaluations = 0.0;
  for (const double e : swept.evaluations)
    evaluations += e * static_cast<double>(fewest_phases);
  findings.count(std::lround(evaluations));
  return {.label = s.scene + ", " + s.method,
          .x = swept.rms.steps(),
          .y = swept.rms.errors(),
          .style = integrator_traits(s.method).is_staggered ? Style::points : Style::linespoints};
}

std::vector<double> counts_of(const Setup& setup, double first, int decades_and_more) {
  std::vector<double> counts;
  for (int i = 0; i < (setup.coarse ? 3 : decades_and_more); ++i)
    counts.push_back(first * std::pow(4.0, i));
  return counts;
}

constexpr const char* one_offset =
    "second-order prediction; 64 phases integrate the fourth-degree polynomial to 1e-3, and the next order is below "
    "that at the smallest step";
constexpr const char* own_offsets =
    "leading-order prediction for uniformly distributed, independent phases of onset and release, which 64 pairs "
    "represent to about 3 %";

/// Reason why the line through six sweeps, from 8 to 8192 steps, may be tilted by 0.33 of the error of the order
/// between the first two.
std::string pair_why(double off) {
  return fmt::format(
      "between 8 and 32 steps the next order shifts the order by {}, and by a quarter as much from one pair of steps "
      "to the next: the line through six is tilted by 0.22 of this; 1.5 times the tilt is allowed in either direction, "
      "for the higher orders",
      off);
}

/// The disc on the wall by one method, undamped and damped: two curves, and their predicted lines.
void study_wall(const std::string& method, Figure& figure, Findings& findings, const Setup& setup) {
  const bool rk4 = method == "rk4";
  // The smallest numbers of steps tilt the line most: a coarse run, with only three sweeps, begins at 32.
  const std::vector<double> wall_counts = counts_of(setup, setup.coarse ? 32.0 : 8.0, 6);
  const PhasedImpact elastic = struck_disc({});
  const PhasedImpact damped = struck_disc({.damping_ratio = wall_damping, .without_dashpot = setup.has("dashpot_off")});
  const double w_tc = 2.0 * std::acos(wall_damping) / std::sqrt(1.0 - wall_damping * wall_damping);
  const double elastic_constant = rk4 ? rk4_elastic_constant(common_offset) : leapfrog_elastic_constant(common_offset);
  const double damped_constant =
      w_tc * (rk4 ? rk4_damped_constant(wall_damping, reference::EndRule::clamped)
                  : leapfrog_impact_error(wall_damping, reference::EndRule::clamped).restitution);
  // Leapfrog, undamped: its period shifts the offset by -pi^2/(24 N), the error by a fraction of -0.411/N. The other
  // values are measured.
  const double elastic_pair = rk4 ? 0.0033 : 0.0277;
  const double damped_pair = rk4 ? 0.0045 : 0.0256;
  const Offset offset = setup.has("commensurate_step") ? Offset::none : Offset::common;
  figure.series.push_back(
      study(findings, {"disc on a wall, undamped", elastic, method, wall_counts, offset, 2, elastic_constant,
                       setup.coarse ? 0.004 : 0.001, one_offset, 0.33 * elastic_pair, pair_why(elastic_pair)}));
  figure.series.push_back(study(findings, {"disc on a wall, damped", damped, method, wall_counts, Offset::own, 1,
                                           damped_constant, setup.coarse ? 0.004 : 0.001,
                                           "first-order prediction; the next order is below 1e-3 at the smallest step",
                                           0.33 * damped_pair, pair_why(damped_pair)}));
  if (integrator_traits(method).is_staggered) return;
  // Labels are drawn at the anchors: those of rk4 away from those of velocity Verlet.
  const double anchor = rk4 ? 4e-4 : 2e-2;
  figure.slopes.push_back(
      {2.0, anchor, elastic_constant * anchor * anchor, fmt::format("{:.3f} h^2", elastic_constant)});
  figure.slopes.push_back({1.0, anchor, damped_constant * anchor, fmt::format("{:.3f} h", damped_constant)});
}

void check_wall(Findings& findings, const Setup& setup) {
  Figure figure{.name = "wall",
                .title = "Disc on a wall",
                .caption =
                    "Root mean square over 64 onset phases of the relative error of the exit speed, against the step "
                    "in contact times, over three decades. Undamped: order 2, also for RK4. Damped ($\\xi$ = 0.2, "
                    "clamped): order 1 for all methods. The points of central difference lie on velocity Verlet's "
                    "lines: both methods compute the same positions and differ only in the reported velocities. "
                    "Dashed: the predicted errors, including their constants.",
                .x = {"step / contact time", "1", true},
                .y = {"rms relative error", "1", true}};
  for (const char* method : {"velocity_verlet", "rk4", "central_difference"}) {
    if (setup.coarse && std::string_view{method} != "velocity_verlet") continue;
    study_wall(method, figure, findings, setup);
  }
  if (!setup.coarse) findings.figure(figure);
}

/// The particle on its cables or the column by one method, undamped and damped: two curves, and their predicted lines.
void study_case(bool cables, const std::string& method, Figure& figure, Findings& findings, const Setup& setup) {
  const bool rk4 = method == "rk4";
  const double xi = reference::damping_ratio(0.5, reference::EndRule::attractive);
  const double w_tc = pi / std::sqrt(1.0 - xi * xi);
  // The struck body's speed is proportional to 1 + e: a relative error r of e changes the speed by e r/(1 + e).
  const double ratio = 0.5 / 1.5;
  const double scatter = setup.coarse ? 0.04 : 0.0104;
  const std::string scatter_why =
      "64 pairs of phases represent all phases to 3 % in each point: the line through six points, a factor of 4 apart, "
      "then scatters by 0.03/(ln 4 sqrt(17.5)) = 0.0052; two standard deviations are allowed (0.04 with three points)";
  const std::string scene = cables ? "two cables" : "pivoted cylinder";
  const auto struck = [&](double e) {
    return cables ? struck_cables(e, setup.has("mass_halved") ? 0.5 : 1.0) : struck_column(e);
  };
  const double damped_constant = ratio * w_tc *
                                 (rk4 ? rk4_damped_constant(xi, reference::EndRule::attractive)
                                      : leapfrog_impact_error(xi, reference::EndRule::attractive).restitution);
  figure.series.push_back(study(findings, {scene + ", damped", struck(0.5), method, counts_of(setup, 8.0, 6),
                                           Offset::own, 1, damped_constant, 0.08, own_offsets, scatter, scatter_why}));
  if (integrator_traits(method).is_staggered) return;
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
        .title =
            cables ? "Validation problem 1: particle between two cables" : "Validation problem 2: pivoted cylinder",
        .caption = fmt::format("Root mean square over 64 phases of the relative error of the {} after the impact, "
                               "against the soft-contact reference: e = 1 (order 2) and e = 0.5 (order 1). Dashed: "
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

Case definition() {
  return {
      .id = "timestep",
      .title = "Convergence with the time step: contacts and smooth motion",
      .family = "founding problems",
      .requirements = {{"Eq. 17", {"undamped_impacts", "damped_impacts"}},
                       {"Eq. 23, Eq. 24", {"leapfrog_orders"}},
                       {"B1", {"disc on a wall, undamped"}},
                       {"law.linear_spring_dashpot", {"undamped_impacts", "damped_impacts"}},
                       {"law.tension_only", {"particle on cables"}},
                       {"end_rule.attractive", {"two cables, damped", "pivoted cylinder, damped"}},
                       {"end_rule.clamped", {"disc on a wall, damped"}},
                       {"method.resultant", {"undamped_impacts", "damped_impacts"}},
                       {"shape.circle", {"disc on a wall, undamped", "disc on a wall, damped"}},
                       {"shape.rectangle", {"pivoted cylinder, undamped", "pivoted cylinder, damped"}},
                       {"shape.half_plane, pair.circle.half_plane",
                        {"disc on a wall, undamped", "disc on a wall, damped"}},
                       {"pair.circle.rectangle", {"pivoted cylinder, undamped", "pivoted cylinder, damped"}},
                       {"pair.circle.circle", {"two cables, undamped", "two cables, damped"}}},
      .main_checks = {"disc on a wall, undamped: order of velocity_verlet", "disc on a wall, undamped: order of rk4",
                      "disc on a wall, damped: order of velocity_verlet",
                      "commensurate steps: false order of velocity_verlet", "commensurate steps: false order of rk4"},
      .source =
          "Mustoe & Huttelmaier 1993, section 5, validation problems 1 and 2, Eqs. 17, 23, 24; error constants derived "
          "here",
      .faults = {{"commensurate_step", "the contact time is an integer number of steps",
                  "disc on a wall, undamped: order of velocity_verlet"},
                 {"dashpot_off", "the dashpot of the wall contact is omitted",
                  "disc on a wall, damped: order of velocity_verlet"},
                 {"mass_halved", "the particle on the cables has half its mass",
                  "two cables, damped: order of velocity_verlet"},
                 {"euler_cromer_for_verlet", "Euler-Cromer in place of velocity Verlet",
                  "particle on cables: order of velocity_verlet"}},
      .seconds = 5.0,
      .run = run};
}

}  // namespace talus::verification::problems::timestep
