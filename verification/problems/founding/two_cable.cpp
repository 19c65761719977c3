#include "verification/reference/cables/two_cable.hpp"
#include "verification/problems/founding/two_cable_impact.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/impacts/followed_impact.hpp"
#include "verification/study/impacts/leapfrog_impact_error.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::two_cable {
namespace {

const reference::TwoCable problem{};

/// Errors of the particle launched at v1 with the striker out of reach: smooth motion under velocity Verlet.
struct Launch {
  double time_error{};      ///< of the turning point, signed [s]
  double distance_error{};  ///< of the turning point, signed [m]
  double curve_error{};     ///< largest |v^2 - v^2(theta)|, Eq. 27 [m^2/s^2]
  Series curve{.label = "solver, every eighth of 160 steps", .style = Style::points};
};
Launch launched(const reference::TwoCableMotion& motion, double turning_time, double v1, double step,
                const Setup& setup, Findings& findings) {
  Scene scene = scene_of({contact_stiffness, 0.0, EndRule::clamped}, setup);
  scene.integrator = setup.has("euler_cromer") ? Integrator{EulerCromer{}} : Integrator{VelocityVerlet{}};
  scene.initial.v = {v1, 0.0, 0.0, 0.0};
  scene.initial.q[2] = -100.0;
  TurningPointFinder finder{0};
  Launch launch;
  const Watcher watch = [&](const State& seen, const StepInfo& info) {
    finder(seen, info);
    const double theta = std::atan(seen.q[0] / problem.length);
    if (finder.found() || theta >= motion.largest_angle()) return;
    const double exact = motion.speed_at_angle(theta);
    keep_largest(launch.curve_error, seen.v[0] * seen.v[0] - exact * exact);
    if (info.step % 8 != 0) return;
    launch.curve.add(theta, seen.v[0]);
  };
  const RunEnd end = run_scene(scene, scene.integrator, {step, 5.0, 5.0, false}, findings, watch,
                               [&](const State&) { return finder.found().has_value(); });
  const bool turned = end.finished && finder.found();
  launch.time_error = turned ? finder.found()->time - turning_time : std::nan("");
  launch.distance_error = turned ? finder.found()->value - motion.largest_distance() : std::nan("");
  return launch;
}

/// D of the Hamiltonian that velocity Verlet conserves, H + h^2 D: v^2 U''/12 - U'^2/(24 m) (Hairer, Lubich & Wanner
/// 2006, IX.8), with U'' = 2 k (1 - l/L + x^2 l/L^3), L = sqrt(l^2 + x^2).
double kept_in_addition(double x, double v) {
  const double l = problem.length, L = std::sqrt(l * l + x * x);
  const double slope = cable_pull(x);
  const double curvature = 2.0 * problem.stiffness * (1.0 - l / L + x * x * l / (L * L * L));
  return v * v * curvature / 12.0 - slope * slope / (24.0 * problem.mass);
}

/// Integral of D over the quarter period launched at v1, by Simpson's rule in u with x = x_max sin u: dt = du
/// sqrt(s_max (L_max + L)/ (1 + s/s_max))/v1, s the elongation (verification/reference/cables/two_cable.hpp).
double integral_in_addition(double v1) {
  const reference::TwoCableMotion motion{problem, v1};
  const double furthest = motion.largest_distance();
  const double longest = std::hypot(problem.length, furthest), maximum = longest - problem.length;
  constexpr int n = 200;
  double sum = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double x = furthest * std::sin(0.5 * std::numbers::pi * i / n);
    const double length = std::hypot(problem.length, x), s = length - problem.length;
    const double rate = std::sqrt(maximum * (longest + length) / (1.0 + s / maximum)) / v1;
    const double v_square = v1 * v1 * (1.0 - s / maximum) * (1.0 + s / maximum);
    sum += (i == 0 || i == n ? 1.0
            : i % 2 == 1     ? 4.0
                             : 2.0) *
           rate * kept_in_addition(x, std::sqrt(std::max(0.0, v_square)));
  }
  return sum * 0.5 * std::numbers::pi / (3.0 * n);
}

/// Checks the errors of the launch at v1 with this step against their predictions.
void check_constants(const reference::TwoCableMotion& motion, double v1, double step, const Launch& launch,
                     Findings& findings) {
  // At the launch D = 0 (the cables have no stiffness across their line), so E is exact; the quarter period at
  // fixed energy changes by -h^2 d/dE of the integral of D, dE = m v1 dv1, and the turn lies where U - h^2 U'^2/(24 m)
  // = E.
  const double dv = 1e-3;
  const double per_energy =
      (integral_in_addition(v1 + dv) - integral_in_addition(v1 - dv)) / (2.0 * dv * problem.mass * v1);
  const double x = motion.largest_distance();
  const double pull = cable_pull(x);
  double largest = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const double at = x * i / 400.0;
    largest = std::max(largest,
                       2.0 / problem.mass * step * step * std::abs(kept_in_addition(at, motion.speed_at_distance(at))));
  }
  const std::string argument =
      "second-order constant derived from the Hamiltonian that the method conserves; the next order is (w h)^2 of it, "
      "with w h = 0.02 at the turning point";
  findings.expect_model({"time_alone", "time of travel, cables alone: error over its prediction"},
                        launch.time_error / (-step * step * per_energy), 1.0, 0.02,
                        argument +
                            "; the cubic interpolation between two steps uses the method's v as dx/dt, which differ by "
                            "h^2 U''/(6 m): about 1 % of the error");
  findings.expect_model({"distance", "distance, cables alone: error over its prediction"},
                        launch.distance_error / (step * step * pull / (24.0 * problem.mass)), 1.0, 1e-3, argument);
  findings.expect_model({"curve_alone", "curve v^2(theta): largest error over its prediction"},
                        launch.curve_error / largest, 1.0, 1e-3, argument);
}

/// Figure of the speed over the angle, solver and Eq. 27.
Figure speed_curve(const reference::TwoCableMotion& motion, const Series& solver) {
  Series exact{.label = "Eq. 27", .style = Style::lines};
  for (int i = 0; i <= 200; ++i) {
    const double theta = motion.largest_angle() * i / 200.0;
    exact.add(theta, motion.speed_at_angle(theta));
  }
  return {.name = "speed_curve",
          .title = "Speed of the particle against the angle of the cables",
          .caption = "Launched at $v_1 = 2$ m/s: velocity Verlet against Eq. 27.",
          .x = {.label = "angle of the cables", .unit = "rad"},
          .y = {.label = "speed", .unit = "m/s"},
          .series = {exact, solver}};
}

/// The particle of the case `two_cable` launched from its unstretched cables, the striker out of reach, by velocity
/// Verlet: orders, and the constants that follow from the Hamiltonian that the method conserves. Fault `euler_cromer`.
void check_cables_alone(Findings& findings, const Setup& setup) {
  const double v1 = reference::rigid_impact(problem).particle;
  const reference::TwoCableMotion motion{problem, v1};
  const double turning_time = motion.time_to_turning();  // at 50 digits: evaluated once
  Convergence time, distance;
  Launch launch;
  double step = 0.0;
  for (const double steps : doublings(20, setup.coarse ? 3 : 4)) {
    step = turning_time / (steps - 0.381966);
    launch = launched(motion, turning_time, v1, step, setup, findings);
    time.add(step, std::abs(launch.time_error));
    distance.add(step, std::abs(launch.distance_error));
  }
  const std::string why =
      "smooth motion with velocity Verlet: even powers of the step only; at 20 steps the fourth order is a few "
      "hundredths of the second";
  findings.expect_order({"order_of_time", "order of the time of travel, cables alone"}, time, 1.95, 2.05, why);
  findings.expect_order({"order_distance", "order of the distance, cables alone"}, distance, 1.95, 2.05, why);
  if (setup.coarse) return;
  check_constants(motion, v1, step, launch, findings);
  findings.figure(speed_curve(motion, launch.curve));
}

/// Error of the speed after the contact relative to the soft reference, against the step: root mean square over the
/// phases within a step at which the surfaces can touch.
Convergence speed_errors(EndRule rule, std::size_t points, const Setup& setup, Findings& findings) {
  const TwoCableEnd end{rule, EndRule::attractive};
  const auto exact = reference::soft_impact(problem, soft_contact(contact_stiffness, end));
  Convergence errors;
  for (const double n : doublings(16, points)) {
    const PhaseError error = phase_error(exact.at_end.t, n, [&](const Phase& phase) {
      Scene scene = scene_of(solver_contact(contact_stiffness, end, setup), setup);
      scene.integrator = CentralDifference{};
      const double gap = phase.lead() * problem.approach_speed;
      return simulated(scene, gap, phase.step, false, findings).speed_after - exact.at_end.particle_velocity;
    });
    errors.add(exact.at_end.t / n, error.rms());
  }
  return errors;
}

/// Checks order and constant for one end rule; returns its curve, with the step in contact times.
Series speed_error_curve(EndRule rule, Findings& findings, const Setup& setup) {
  const bool attractive = rule == EndRule::attractive;
  const std::string name = attractive ? "attractive" : "clamped";
  const Convergence errors = speed_errors(rule, setup.coarse ? 3 : 6, setup, findings);
  findings.expect_order(
      {"speed_order", "order of the speed after the impact, " + name}, errors, 0.95, 1.05,
      "a force jump 2 xi m w0 v0 at any time within a step causes an impulse error of first order; at the coarsest "
      "step, w h = 0.2, the second order adds about w h/4 of it, which tilts the fitted line by 0.03");
  const double w = std::sqrt(contact_stiffness / reduced_mass());
  const double xi = reference::damping_ratio(problem.restitution, reference::EndRule::attractive);
  const double predicted = leapfrog_impact_error(xi, same(rule)).restitution * w * particle_fraction() *
                           reference::restitution(xi, same(rule)) * problem.approach_speed;
  findings.expect_model(
      "error constant of the speed after the impact, " + name,
      errors.errors().back() / (predicted * errors.steps().back()), 1.0, attractive ? 0.05 : 0.01,
      "predicted from the lag of the dashpot and its force jumps: 64 phases represent the one jump of the clamped "
      "contact to 1 %, 64 pairs of phases the two jumps of the attractive contact to 5 %");
  const auto exact = reference::soft_impact(problem, soft_contact(contact_stiffness, {rule, EndRule::attractive}));
  Series series{.label = name, .x = {}, .y = errors.errors()};
  for (const double step : errors.steps())
    series.x.push_back(step / exact.at_end.t);
  return series;
}

/// Compares the speed after the contact at one stiffness, by central difference, with the soft reference: order and
/// predicted constant for both end rules, and a figure.
void check_contact_at_fixed_stiffness(Findings& findings, const Setup& setup) {
  Figure figure{
      .name = "speed_error",
      .title = "Error of the speed after the contact against the soft reference",
      .caption =
          "Central difference, $k_n = 10^4$ N/m, root mean square over 64 phases of the onset. The dashpot's force "
          "jumps at both ends of the attractive contact and at the onset of the clamped one, so the order is one.",
      .x = {.label = "step / contact time", .log = true},
      .y = {.label = "error of the speed", .unit = "m/s", .log = true}};
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    const Series series = speed_error_curve(rule, findings, setup);
    figure.series.push_back(series);
    if (rule == EndRule::attractive) figure.slopes.push_back({1.0, series.x.front(), 0.4 * series.y.front(), "h"});
  }
  findings.figure(figure);
}

/// Distance at which the particle's speed has fallen to v [m], by bisection of the monotone v(x).
double distance_at_speed(const reference::TwoCableMotion& motion, double v) {
  double low = 0.0, high = motion.largest_distance();
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (motion.speed_at_distance(middle) > v ? low : high) = middle;
  }
  return low;
}

/// Checks the balances of a production run, and the curve v^2(theta) after the impact.
void check_accounts(Findings& findings, const std::string& name, TwoCableEnd end, const TwoCableRun& run, double step) {
  const auto soft = reference::soft_impact(problem, soft_contact(contact_stiffness, end));
  findings.expect_round_off(
      "momentum balance error, " + name, run.momentum_balance_error, 0.0, 3e-14,
      "1e5 steps add the same force to both bodies and to the impulse: three roundings of at most eps/2 M v0 each, "
      "6.4e-17 rms: sqrt(3e5) x 6.4e-17 = 3.5e-14 as a random walk, less because the momentum decreases");
  const double pull = cable_pull(soft.turning_distance);
  findings.expect_model(
      {"curve_after", "curve v^2(theta) after the impact, error over its prediction, " + name},
      run.curve_error * 6.0 * problem.mass * problem.mass / (step * step * pull * pull), 1.0, 0.002,
      "central difference conserves H + h^2 (U'^2/(12 m) - v^2 U''/24); the error of v^2 is largest at the turning "
      "point, h^2 U'^2/(6 m^2); the last step before it and an error of 1e-4 of x_max change this by less than 0.002");
  if (end.rule == EndRule::clamped) return;
  const double xi = reference::damping_ratio(problem.restitution, same(end.formula));
  const double predicted_error = 0.25 * step * 2.0 * xi * std::sqrt(contact_stiffness * reduced_mass()) *
                                 (1.0 - problem.restitution * problem.restitution) * problem.approach_speed *
                                 problem.approach_speed;
  findings.expect_model("energy balance error over its prediction", run.energy_balance_error / predicted_error, 1.0,
                        0.005,
                        "the power of the dashpot is computed with the velocity of half a step before: h c (1 - e^2) "
                        "v0^2/4; the end of the contact within a step, xi w h of it, is not included");
}

/// Runs one production run and compares it with the soft reference.
TwoCableRun check_production_run(Findings& findings, const Setup& setup, const std::string& name, TwoCableEnd end) {
  constexpr double n = 1024.0;
  const auto soft = reference::soft_impact(problem, soft_contact(contact_stiffness, end));
  const double step = incommensurate_step(soft.at_end.t, n);
  Scene scene = scene_of(solver_contact(contact_stiffness, end, setup), setup);
  scene.integrator = CentralDifference{};
  const TwoCableRun run = simulated(scene, 0.0, step, true, findings);
  // The touch coincides with the start of a step. The only first-order errors are therefore the dashpot's lag and, for
  // the attractive rule, the jump at the end, which occurs within half a step of its exact time.
  const double xi = reference::damping_ratio(problem.restitution, same(end.formula));
  const double wh = std::sqrt(contact_stiffness / reduced_mass()) * step;
  const double after = particle_fraction() * reference::restitution(xi, same(end.rule)) * problem.approach_speed;
  const double lag = after * wh * leapfrog_restitution_shift(xi, same(end.rule));
  const double jump = end.rule == EndRule::attractive ? after * xi * wh : 0.0;
  const double second_order = after * wh * wh;
  findings.expect_truncation(
      {"speed_after", "speed after the impact, " + name}, run.speed_after, soft.at_end.particle_velocity + lag,
      jump + second_order, 1.0,
      "reference with the predicted lag of the dashpot; the remainder is the force jump at the attractive end, within "
      "half a step (xi w h e v0 M/(M+m)), and the second order, (w h)^2 e v0 M/(M+m)",
      "m/s");
  const double slope = 0.98;  // dx/dv1 = m v1/(dU/dx) at the turn [s]
  findings.expect_truncation({"distance_after", "distance, " + name}, run.turning.value,
                             soft.turning_distance + slope * lag, slope * (jump + second_order), 1.0,
                             "as for the speed, times dx/dv1 = 0.98 s at the turning point", "m");
  findings.expect_truncation({"time_to_turn", "time to the turning point, " + name}, run.turning.time,
                             soft.turning_time, 0.63 * (std::abs(lag) + jump) + step, 1.0,
                             "as for the speed, times |dt/dv1| = t/(2 v1) = 0.63 s^2/m of a motion under a cubic "
                             "force; and the end of the contact within a step",
                             "s");
  check_accounts(findings, name, end, run, step);
  return run;
}

/// Compares the production runs with the rigid impact and the report.
void check_production(Findings& findings, const Setup& setup) {
  const reference::TwoCableImpact rigid = reference::rigid_impact(problem);
  const reference::TwoCableMotion motion{problem, rigid.particle};
  Table table{"end_rules",
              "The two end rules with the same dashpot from Eq. 21 ($k_n = 10^4$ N/m, central difference, 1024 steps "
              "per contact). The report's 3.826 m results from the attractive rule. In the last row the dashpot is "
              "calibrated for $e = 0.5$ with the clamped rule.",
              {"end rule", "v after [m/s]", "turning distance [m]", "theta [rad]", "time to turning point [s]"},
              {}};
  const auto row = [&](const std::string& name, double v, double x, double t) {
    table.rows.push_back(cells("{} | {:.4f} | {:.5f} | {:.5f} | {:.4f}", name, v, x, std::atan(x / problem.length), t));
  };
  row("rigid impact, exact", rigid.particle, motion.largest_distance(), motion.time_to_turning());
  table.rows.push_back({"report (1993)", "1.997", "3.826", "0.365", "not given"});
  const struct {
    const char* name;
    TwoCableEnd end;
  } runs[] = {{"attractive", {EndRule::attractive, EndRule::attractive}},
              {"clamped", {EndRule::clamped, EndRule::attractive}},
              {"clamped, recalibrated dashpot", {EndRule::clamped, EndRule::clamped}}};
  for (const auto& [name, end] : runs) {
    const TwoCableRun run = check_production_run(findings, setup, name, end);
    row(name, run.speed_after, run.turning.value, run.turning.time);
    if (std::string{name} != "attractive") continue;
    findings.expect_model({"printed_distance", "distance, as the report prints it"}, run.turning.value, 3.826, 6e-4,
                          "half a unit of the last printed digit, and 1e-4 for the error of the step", "m");
    findings.expect_model({"printed_angle", "angle, as the report prints it"},
                          std::atan(run.turning.value / problem.length), 0.365, 5e-4,
                          "half a unit of the last printed digit; exact 0.36546", "rad");
  }
  findings.table(table);
  const double slowed = 1.997;
  findings.note(
      fmt::format("The report's 1.997 m/s and 3.826 m do not belong to the same instant: a particle that leaves with "
                  "1.997 m/s turns at {:.4f} m. By Eq. 27 a particle that leaves with 2 m/s has slowed down to 1.997 "
                  "m/s at {:.2f} m, {:.2f} s later; the report may have read its Fig. 8 there. The difference of 0.003 "
                  "m/s is reported without fitting anything to it.",
                  reference::TwoCableMotion{problem, slowed}.largest_distance(), distance_at_speed(motion, slowed),
                  motion.time_to_distance(distance_at_speed(motion, slowed))));
}

Figure rigid_limit(const Convergence& distance, const Convergence& time, const std::vector<double>& soft_distance,
                   const std::vector<double>& soft_time) {
  return {.name = "rigid_limit",
          .title = "Approach to the rigid impact",
          .caption =
              "Difference of turning distance and travel time from the rigid impact, against the contact compliance: "
              "the solver (points) and the soft reference (lines), attractive end rule.",
          .x = {.label = "contact compliance 1/k_n", .unit = "m/N", .log = true},
          .y = {.label = "error against rigid impact", .unit = "m, s", .log = true},
          .series = {{"distance [m], solver", distance.steps(), distance.errors(), Style::points},
                     {"distance [m], soft reference", distance.steps(), soft_distance, Style::lines},
                     {"time [s], solver", time.steps(), time.errors(), Style::points},
                     {"time [s], soft reference", time.steps(), soft_time, Style::lines}},
          .slopes = {{2.0, distance.steps().front(), 0.3 * distance.errors().front(), "1/k_n^2"},
                     {0.5, time.steps().front(), 0.4 * time.errors().front(), "1/k_n^{1/2}"}}};
}

/// Approach of the results to the rigid impact as the contact stiffness increases. The step is controlled (tolerance
/// 1e-12), so that the only remaining difference is the contact's softness.
void check_rigid_limit(Findings& findings, const Setup& setup) {
  const reference::TwoCableImpact rigid = reference::rigid_impact(problem);
  const reference::TwoCableMotion motion{problem, rigid.particle};
  constexpr TwoCableEnd end{EndRule::attractive, EndRule::attractive};
  Convergence distance, time;
  std::vector<double> soft_distance, soft_time;
  double apart = 0.0;
  for (double k = 16.0; k <= (setup.coarse ? 64.0 : 1024.0); k *= 4.0) {
    Scene scene = scene_of(solver_contact(k, end, setup), setup);
    scene.integrator = make_integrator("odeint_dopri5", 1e-12);
    const TwoCableRun run = simulated(scene, 0.0, 5e-3, true, findings);
    const auto soft = reference::soft_impact(problem, soft_contact(k, end));
    distance.add(1.0 / k, std::abs(run.turning.value - motion.largest_distance()));
    time.add(1.0 / k, std::abs(run.turning.time - motion.time_to_turning()));
    soft_distance.push_back(std::abs(soft.turning_distance - motion.largest_distance()));
    soft_time.push_back(std::abs(soft.turning_time - motion.time_to_turning()));
    keep_largest(apart, run.turning.value - soft.turning_distance);
  }
  findings.expect_truncation(
      "turning distance with step control, largest difference from the soft reference", apart, 0.0, 1e-9, 1.0,
      "about 500 steps with local errors below 1e-12 (1 + |x| + h |v|), at most 5e-12 each: 1e-10 if they accumulate "
      "as a random walk, 2.5e-9 if all have the same sign; in between, because neighbouring errors of a smooth motion "
      "are alike; the end of the contact lies within a step short enough for the same tolerance",
      "m");
  findings.expect_order({"distance_to_rigid", "turning distance, approach to the rigid limit, power of 1/k_n"},
                        distance, 1.995, 2.005,
                        "the impulse of the cables during the contact is proportional to the fourth power of its "
                        "duration; the next term is 1/k_n of it");
  findings.expect_order({"time_to_rigid", "travel time, approach to the rigid limit, power of 1/k_n"}, time, 0.495,
                        0.505, "the particle leaves later by a fraction of the contact time");
  findings.figure(rigid_limit(distance, time, soft_distance, soft_time));
}

void run(Findings& findings, const Setup& setup) {
  check_production(findings, setup);
  check_contact_at_fixed_stiffness(findings, setup);
  check_rigid_limit(findings, setup);
  check_cables_alone(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "two_cable",
      .title = "Two-cable particle impact",
      .family = "founding problems",
      .requirements =
          {{"Eq. 13", {"order_distance", "distance"}},
           {"Eq. 14",
            {"distance_after", "printed_distance", "order_of_time", "order_distance", "time_alone", "distance"}},
           {"Eq. 15", {"curve_after", "order_of_time", "order_distance", "time_alone", "distance", "curve_alone"}},
           {"Eq. 17", {"speed_after", "speed_order"}},
           {"Eq. 21", {"speed after the impact, attractive", "order of the speed after the impact, attractive"}},
           {"Eq. 23, Eq. 24", {"speed_order"}},
           {"Eq. 26", {"speed_after", "printed_distance", "printed_angle"}},
           {"Eq. 27",
            {"time_to_turn", "curve_after", "order_of_time", "order_distance", "time_alone", "distance",
             "curve_alone"}},
           {"law.linear_spring_dashpot", {"speed_after", "speed_order", "distance_to_rigid", "time_to_rigid"}},
           {"law.tension_only",
            {"curve_after", "order_of_time", "order_distance", "time_alone", "distance", "curve_alone"}},
           {"end_rule.attractive",
            {"speed after the impact, attractive", "distance, attractive", "time to the turning point, attractive",
             "momentum balance error, attractive",
             "curve v^2(theta) after the impact, error over its prediction, attractive", "printed_distance",
             "printed_angle", "order of the speed after the impact, attractive",
             "error constant of the speed after the impact, attractive"}},
           {"end_rule.clamped",
            {"speed after the impact, clamped", "speed after the impact, clamped, recalibrated dashpot",
             "distance, clamped", "distance, clamped, recalibrated dashpot", "time to the turning point, clamped",
             "time to the turning point, clamped, recalibrated dashpot", "momentum balance error, clamped",
             "momentum balance error, clamped, recalibrated dashpot",
             "curve v^2(theta) after the impact, error over its prediction, clamped",
             "curve v^2(theta) after the impact, error over its prediction, clamped, recalibrated dashpot",
             "order of the speed after the impact, clamped", "error constant of the speed after the impact, clamped"}},
           {"method.resultant", {"speed_after", "speed_order"}},
           {"shape.circle", {"speed_after"}},
           {"integrator.central_difference", {"speed_after", "speed_order"}},
           {"integrator.velocity_verlet", {"order_of_time", "order_distance", "time_alone", "distance"}},
           {"integrator.odeint_dopri5", {"distance_to_rigid", "time_to_rigid"}},
           {"pair.circle.circle", {"speed_after"}}},
      .main_checks = {"speed after the impact, attractive", "distance, attractive", "printed_angle",
                      "time to the turning point, attractive", "order_of_time"},
      .source = "Mustoe & Huttelmaier 1993, section 5, validation problem 1, Eqs. 26-27",
      .faults = {{"mass_halved", "the particle has half its mass", "distance, attractive"},
                 {"cable_stiffness_per_length", "the cable's stiffness is divided by its length",
                  "distance, attractive"},
                 {"wrong_end_rule", "clamped end rule instead of the attractive one", "printed_distance"},
                 {"dashpot_halved", "Eq. 21 without its factor 2", "speed after the impact, attractive"},
                 {"euler_cromer", "Euler-Cromer instead of velocity Verlet: velocities and positions half a step apart",
                  "order_of_time"}},
      .run = run};
}

}  // namespace talus::verification::problems::two_cable
