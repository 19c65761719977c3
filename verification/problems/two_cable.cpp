#include "verification/reference/two_cable.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "solver/calibrate/restitution.hpp"
#include "solver/run/energy_ledger.hpp"
#include "solver/run/turning_point.hpp"
#include "solver/scenes/two_cable.hpp"
#include "verification/check/case.hpp"
#include "verification/check/convergence.hpp"
#include "verification/reference/restitution.hpp"
#include "verification/reference/two_cable_contact.hpp"

namespace talus::verification::problems {
namespace {

constexpr const char* page = R"(
**Problem.** A particle of mass $m$ rests between two unstretched cables; a striker of mass $M$ hits it at speed $v_0$ with
restitution $e$. How fast does it leave, how far does it go, and how long does it take? There is no gravity.

```
        anchor                 y
          |  k, l              |
  M -->  (m)                   +--- x
          |  k, l
        anchor
```

**Equations.** Momentum and restitution give the velocity after a rigid impact (Eq. 26),
$$v_1 = \frac{M(1+e)\,v_0}{M+m}.$$
At displacement $x = l\tan\theta$ each cable is stretched by $s = l\,(1-\cos\theta)/\cos\theta$, so that energy gives (Eq. 27)
$$v^2(\theta) = v_1^2 - \frac{2 k l^2 (1-\cos\theta)^2}{m\cos^2\theta},$$
and the time to the turning point is $\int dx/v(x)$, which with $x = x_{max}\sin u$ has no singularity left and is taken at 50
digits. The solver knows none of this: it has a contact of stiffness $k_n$ with a dashpot from Eq. 21, and tension-only cables.
While the contact lasts the cables already act, so Eq. 26 is the limit of $k_n \to \infty$. In the attractive case the particle
leaves the contact slower by the cables' impulse: displacement $\sim v_0 t_c$, force $\sim k x^3/l^2$, impulse
$\sim t_c^4 \sim k_n^{-2}$. The time of travel is later by a share of the contact time, $\sim k_n^{-1/2}$.

**Source.** Mustoe & Huttelmaier 1993, section 5, validation problem 1, Eqs. 21, 26, 27, Fig. 8. The report prints 1.997 m/s,
3.826 m and .365 rad. Soft reference: the same contact as an ordinary differential equation, integrated by odeint's Fehlberg 7(8)
in long double with located events.

| symbol | meaning | value |
|:--|:-----------|:--|
| $k$, $l$ | cable stiffness and length | 4 N/m, 10 m |
| $m$, $M$ | particle, striker | 1 kg, 2 kg |
| $v_0$, $e$ | speed of the striker, restitution | 2 m/s, .5 |
| $k_n$ | contact stiffness where not varied | $10^4$ N/m |

**What would break this.** A wrong reduced mass or a missing factor in Eq. 21; a contact that stops pulling before it ends (that is
the other end rule: 3.892 m); a cable that pushes, or has its stiffness per metre; a force on one body without its reaction.
)";

constexpr double contact_stiffness = 1e4;
const reference::TwoCable problem{};

/// Damping ratio of the scene's contact, by Eq. 21 unless a fault halves it.
LinearSpringDashpot contact(double stiffness, double e_of_dashpot, EndRule rule, const Setup& setup) {
  const double reduced = effective_mass({problem.mass, {}, 0.0, false}, {problem.striker_mass, {}, 0.0, false});
  const double c = damping(damping_ratio(e_of_dashpot, EndRule::attractive), stiffness, reduced);
  return {stiffness, setup.has("dashpot_halved") ? 0.5 * c : c, rule};
}

Scene scene_of(const LinearSpringDashpot& law, const Setup& setup) {
  scenes::TwoCable parameters{.contact = law};
  if (setup.has("mass_halved")) parameters.mass *= 0.5;
  if (setup.has("cable_stiffness_per_length")) parameters.cable_stiffness /= parameters.cable_length;
  return scenes::two_cable(parameters);
}

/// Reference and solver name the end rules alike and share no type.
reference::EndRule same(EndRule rule) {
  return rule == EndRule::attractive ? reference::EndRule::attractive : reference::EndRule::clamped;
}

/// What the solver gives for one impact.
struct Run {
  double speed_after{};       ///< of the particle when the contact has ended [m/s]
  double striker_after{};     ///< [m/s]
  TurningPoint turning;       ///< of the particle
  double energy_closure{};    ///< largest, over the largest kinetic energy
  double momentum_closure{};  ///< largest, over M v0
};

/// Runs the scene with the surfaces `gap` apart at t = 0, until the particle turns, or only until the contact has
/// ended.
Run simulated(Scene scene, double gap, double step, bool to_the_turn, Findings& findings) {
  scene.initial.q[2] -= gap;
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics};
  Workspace work = dynamics.workspace();
  EnergyLedger ledger{dynamics, scene.initial};
  TurningPointFinder finder{0};
  Run run;
  bool touched = false, ended = false;
  const Observer watch = [&](const State& state, const StepInfo& info) {
    finder(state, info);
    dynamics.update(state, work);
    const bool acts = state.mode[0] == UnilateralSpring::acting && work.gaps[0].depth >= 0.0;
    touched = touched || acts;
    if (touched && !acts && !ended) {
      ended = true;
      run.speed_after = state.v[0];
      run.striker_after = state.v[2];
    }
    if (!to_the_turn) return;
    const Accounts accounts = ledger.accounts(state);
    run.momentum_closure = std::max(run.momentum_closure, std::abs(accounts.momentum_closure.x));
  };
  State state = scene.initial;
  const RunPlan plan{step, 5.0, 5.0, to_the_turn};
  const StopCondition stop = [&](const State&) { return to_the_turn ? finder.found().has_value() : ended; };
  const Outcome outcome = simulate(system, scene.integrator, state, plan, {&watch, 1}, stop);
  findings.count(static_cast<std::uint64_t>(system.evaluations()));
  const double nan = std::nan("");
  if (!outcome || !ended) run.speed_after = run.striker_after = nan;
  run.turning = outcome && finder.found() ? *finder.found() : TurningPoint{nan, nan};
  run.energy_closure = ledger.largest_energy_closure() / ledger.energy_scale();
  run.momentum_closure /= problem.striker_mass * problem.approach_speed;
  return run;
}

/// Time from touch to the end of the contact, soft reference [s].
double contact_duration(const LinearSpringDashpot& law) {
  return reference::soft_impact(problem, {law.stiffness, law.damping, same(law.end_rule)}).at_end.t;
}

/// Error of the speed after the contact against the soft reference, root mean square over the phases at which the
/// surfaces can meet within a step, against the step.
Convergence speed_errors(EndRule rule, std::size_t points, const Setup& setup, Findings& findings) {
  const LinearSpringDashpot law = contact(contact_stiffness, problem.restitution, rule, setup);
  const LinearSpringDashpot right = contact(contact_stiffness, problem.restitution, rule, {});
  const auto exact = reference::soft_impact(problem, {right.stiffness, right.damping, same(rule)});
  Convergence errors;
  for (const double n : doublings(16, points)) {
    PhaseError phases;
    for (std::size_t i = 0; i < fewest_phases; ++i) {
      const double step = offset_step(exact.at_end.t, n, i);
      Scene scene = scene_of(law, setup);
      scene.integrator = CentralDifference{};
      const double gap = even_phases(fewest_phases)[i] * step * problem.approach_speed;
      phases.add(simulated(scene, gap, step, false, findings).speed_after - exact.at_end.particle_velocity);
    }
    errors.add(exact.at_end.t / n, phases.rms());
  }
  return errors;
}

void check_contact_at_fixed_stiffness(Findings& findings, const Setup& setup) {
  Figure figure{
      .name = "speed_error",
      .title = "Speed after the contact, error against the soft reference",
      .caption =
          "Central difference, $k_n = 10^4$ N/m, root mean square over 64 phases of the onset. The dashpot's force "
          "jumps at both ends of the contact, so the order is one.",
      .x = {.label = "step / contact time", .log = true},
      .y = {.label = "error of the speed", .unit = "m/s", .log = true},
      .series = {}};
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    const bool attractive = rule == EndRule::attractive;
    const std::string name = attractive ? "attractive" : "clamped";
    const Convergence errors = speed_errors(rule, setup.coarse ? 3 : 6, setup, findings);
    findings.expect_order("order of the speed, " + name, errors, 0.85, 1.15,
                          "a force jump 2 xi m w0 v0 met anywhere within a step leaves an impulse error of first "
                          "order; 64 phases, offset steps");
    const double duration = contact_duration(contact(contact_stiffness, problem.restitution, rule, {}));
    Series series{.label = name, .x = {}, .y = errors.errors()};
    for (const double step : errors.steps())
      series.x.push_back(step / duration);
    figure.series.push_back(series);
    if (attractive) figure.slopes.push_back({1.0, series.x.front(), 0.5 * series.y.front(), "h"});
  }
  findings.figure(figure);
}

/// The production run: 1024 steps in a contact, surfaces touching at t = 0, compared with the rigid impact and the
/// report.
void check_production(Findings& findings, const Setup& setup) {
  const reference::TwoCableImpact rigid = reference::rigid_impact(problem);
  const reference::TwoCableMotion motion{problem, rigid.particle};
  Table table{
      "end_rules",
      "The two end rules, the same dashpot by Eq. 21 ($k_n = 10^4$ N/m, central difference, 1024 steps in a contact). "
      "The "
      "report's 3.826 m comes from the attractive rule. The last row has the dashpot that the clamped rule needs for "
      "$e = .5$.",
      {"contact end", "v after [m/s]", "turns at [m]", "theta [rad]", "time to turn [s]"},
      {}};
  const auto row = [&](const std::string& name, double v, double x, double t) {
    table.rows.push_back({name, fmt::format("{:.4f}", v), fmt::format("{:.5f}", x),
                          fmt::format("{:.5f}", std::atan(x / problem.length)), fmt::format("{:.4f}", t)});
  };
  row("rigid impact, exact", rigid.particle, motion.largest_distance(), motion.time_to_turning());
  table.rows.push_back({"report (1993)", "1.997", "3.826", "0.365", "not given"});
  const double clamped_e = reference::restitution(
      reference::damping_ratio(problem.restitution, reference::EndRule::clamped), reference::EndRule::attractive);
  const struct {
    const char* name;
    EndRule rule;
    double e_of_dashpot;
  } ends[] = {{"attractive", EndRule::attractive, problem.restitution},
              {"clamped", EndRule::clamped, problem.restitution},
              {"clamped, own dashpot", EndRule::clamped, clamped_e}};
  for (const auto& end : ends) {
    const EndRule rule = setup.has("wrong_end_rule") ? EndRule::clamped : end.rule;
    const LinearSpringDashpot law = contact(contact_stiffness, end.e_of_dashpot, rule, setup);
    const LinearSpringDashpot right = contact(contact_stiffness, end.e_of_dashpot, end.rule, {});
    const auto soft = reference::soft_impact(problem, {right.stiffness, right.damping, same(end.rule)});
    // Constants of the first-order error: measured by the convergence study above (.27 m/s at one step in a contact for
    // both rules); the turning point follows by dx/dv = .98 s (energy at the turn).
    const double n = 1024.0;
    const double speed_error = 0.45 / n;
    Scene scene = scene_of(law, setup);
    scene.integrator = CentralDifference{};
    const Run run = simulated(scene, 0.0, incommensurate_step(soft.at_end.t, n), true, findings);
    const std::string name{end.name};
    const std::string why =
        "first-order error of a contact with a dashpot: measured largest constant .45 m/s a step in a contact";
    findings.expect("speed after the impact, " + name, run.speed_after, soft.at_end.particle_velocity,
                    Tolerance::truncation(speed_error, 2.0, why), "m/s");
    findings.expect("distance, " + name, run.turning.value, soft.turning_distance,
                    Tolerance::truncation(speed_error * 0.98, 2.0, why + "; distance by dx/dv1 = .98 s"), "m");
    findings.expect("momentum, " + name, run.momentum_closure, 0.0,
                    Tolerance::round_off(2e-12,
                                         "1e5 steps add the same force to both bodies: sqrt(1e5) roundings of M v0, "
                                         "times three bookings each, 2e-13, and ten times that for drift"));
    row(name, run.speed_after, run.turning.value, run.turning.time);
    if (name != "attractive") continue;
    findings.expect(
        "speed, as the report prints it", run.speed_after, 1.997,
        Tolerance::model(4e-3,
                         "the report's own contact stiffness and step are unknown; its distance to the exact 2 is "
                         "3e-3, one more unit of its last digit is allowed"),
        "m/s");
    findings.expect("distance, as the report prints it", run.turning.value, 3.826,
                    Tolerance::model(1e-3, "half a unit of the last printed digit, and as much for the steps of both"),
                    "m");
    findings.expect("angle, as the report prints it", std::atan(run.turning.value / problem.length), 0.365,
                    Tolerance::model(5e-4, "half a unit of the last printed digit; exact .36546"), "rad");
  }
  findings.table(table);
}

/// As the contact stiffens the answers approach the rigid impact. The step is controlled (tolerance 1e-12), so that
/// what is left is the contact's softness alone.
void check_rigid_limit(Findings& findings, const Setup& setup) {
  const reference::TwoCableImpact rigid = reference::rigid_impact(problem);
  const reference::TwoCableMotion motion{problem, rigid.particle};
  Convergence distance, time;
  std::vector<double> soft_distance, soft_time;
  for (double k = 16.0; k <= (setup.coarse ? 64.0 : 1024.0); k *= 4.0) {
    const LinearSpringDashpot law = contact(k, problem.restitution, EndRule::attractive, setup);
    Scene scene = scene_of(law, setup);
    scene.integrator = make_integrator("odeint_dopri5", 1e-12);
    const Run run = simulated(scene, 0.0, 5e-3, true, findings);
    const auto soft = reference::soft_impact(problem, {law.stiffness, law.damping, reference::EndRule::attractive});
    distance.add(1.0 / k, std::abs(run.turning.value - motion.largest_distance()));
    time.add(1.0 / k, std::abs(run.turning.time - motion.time_to_turning()));
    soft_distance.push_back(std::abs(soft.turning_distance - motion.largest_distance()));
    soft_time.push_back(std::abs(soft.turning_time - motion.time_to_turning()));
  }
  findings.expect_order("distance to the rigid limit, power of 1/k_n", distance, 1.95, 2.05,
                        "the cables' impulse during the contact goes with the fourth power of its duration");
  findings.expect_order("time to the rigid limit, power of 1/k_n", time, 0.495, 0.505,
                        "the particle leaves later by a share of the contact time");
  findings.figure(
      {.name = "rigid_limit",
       .title = "Approach to the rigid impact",
       .caption = "Difference of turning distance and travel time to the rigid impact against the contact's stiffness: "
                  "the solver (points) and the soft reference (lines), attractive end rule.",
       .x = {.label = "contact compliance 1/k_n", .unit = "m/N", .log = true},
       .y = {.label = "difference to the rigid impact", .unit = "m, s", .log = true},
       .series = {{"distance [m], solver", distance.steps(), distance.errors(), Style::points},
                  {"distance [m], soft reference", distance.steps(), soft_distance, Style::lines},
                  {"time [s], solver", time.steps(), time.errors(), Style::points},
                  {"time [s], soft reference", time.steps(), soft_time, Style::lines}},
       .slopes = {{2.0, distance.steps().front(), 0.3 * distance.errors().front(), "1/k_n^2"},
                  {0.5, time.steps().front(), 0.4 * time.errors().front(), "1/k_n^{1/2}"}}});
}

/// The cables alone: the particle is launched at v1, without a striker in reach, so that the motion is smooth.
void check_cables_alone(Findings& findings, const Setup& setup) {
  const double v1 = reference::rigid_impact(problem).particle;
  const reference::TwoCableMotion motion{problem, v1};
  Convergence time, distance;
  Series measured{.label = "solver, every eighth of 160 steps", .x = {}, .y = {}, .style = Style::points};
  double worst_speed = 0.0;
  for (const double steps : doublings(20, setup.coarse ? 3 : 5)) {
    Scene scene = scene_of({contact_stiffness, 0.0, EndRule::clamped}, setup);
    scene.integrator = setup.has("euler_cromer") ? Integrator{EulerCromer{}} : Integrator{VelocityVerlet{}};
    scene.initial.v = {v1, 0.0, 0.0, 0.0};
    scene.initial.q[2] = -100.0;
    const Dynamics dynamics{scene.model};
    RigidBodySystem system{dynamics, false};
    TurningPointFinder finder{0};
    State state = scene.initial;
    const double step = motion.time_to_turning() / (steps - 0.381966);
    const Observer watch = [&](const State& seen, const StepInfo& info) {
      finder(seen, info);
      if (steps != 160.0 || finder.found()) return;
      const double theta = std::atan(seen.q[0] / problem.length);
      if (info.step % 8 == 0) {
        measured.x.push_back(theta);
        measured.y.push_back(seen.v[0]);
      }
      if (theta < motion.largest_angle()) {
        worst_speed =
            std::max(worst_speed, std::abs(seen.v[0] * seen.v[0] - std::pow(motion.speed_at_angle(theta), 2)));
      }
    };
    const Outcome outcome = simulate(system, scene.integrator, state, {step, 5.0, 5.0, false}, {&watch, 1},
                                     [&](const State&) { return finder.found().has_value(); });
    findings.count(static_cast<std::uint64_t>(system.evaluations()));
    const bool turned = outcome && finder.found();
    time.add(step, turned ? std::abs(finder.found()->time - motion.time_to_turning()) : std::nan(""));
    distance.add(step, turned ? std::abs(finder.found()->value - motion.largest_distance()) : std::nan(""));
  }
  findings.expect_order("order of the time of travel, cables alone", time, 1.9, 2.1,
                        "smooth motion under velocity Verlet: even powers of the step only");
  findings.expect_order("order of the distance, cables alone", distance, 1.9, 2.1,
                        "smooth motion under velocity Verlet: even powers of the step only");
  if (setup.coarse) return;
  findings.expect("time of travel, cables alone", motion.time_to_turning() + time.errors().back(),
                  motion.time_to_turning(),
                  Tolerance::truncation(Convergence{time}.between(time.steps()[3], 1.0).fit().at(time.steps().back()),
                                        1.2, "second-order law fitted to the four coarser steps"),
                  "s");
  findings.expect(
      "curve v^2(theta), largest error", worst_speed, 0.0,
      Tolerance::truncation(2.0 * std::pow(time.steps()[3], 2) / 24.0 * 4.0 * 0.55, 3.0,
                            "Verlet keeps an energy that differs from the true one by h^2/24 (2 v.F'v - F^2/m); here "
                            "v^2 dF/dx is at most .55 of v1^2"),
      "m^2/s^2");
  Series exact{.label = "Eq. 27", .x = {}, .y = {}, .style = Style::lines};
  for (int i = 0; i <= 200; ++i) {
    const double theta = motion.largest_angle() * i / 200.0;
    exact.x.push_back(theta);
    exact.y.push_back(motion.speed_at_angle(theta));
  }
  findings.figure({.name = "speed_curve",
                   .title = "Speed of the particle over the angle of the cables",
                   .caption = "Launched at $v_1 = 2$ m/s: velocity Verlet against Eq. 27.",
                   .x = {.label = "angle of the cables", .unit = "rad"},
                   .y = {.label = "speed", .unit = "m/s"},
                   .series = {exact, measured}});
}

void run(Findings& findings, const Setup& setup) {
  check_production(findings, setup);
  check_contact_at_fixed_stiffness(findings, setup);
  check_rigid_limit(findings, setup);
  check_cables_alone(findings, setup);
}

}  // namespace

Case two_cable() {
  return {.id = "two_cable",
          .title = "Two-cable particle impact",
          .requirements = {{"Eq. 13", {"distance, cables alone"}},
                       {"Eq. 14", {"cables alone", "distance, "}},
                       {"Eq. 15", {"cables alone", "curve v^2(theta)"}},
                       {"Eq. 17", {"speed after the impact", "order of the speed"}},
                       {"Eq. 21", {"speed after the impact, attractive", "order of the speed, attractive"}},
                       {"Eq. 23", {"order of the speed"}},
                       {"Eq. 24", {"order of the speed"}},
                       {"Eq. 26", {"speed after the impact", "as the report prints it"}},
                       {"Eq. 27", {"curve v^2(theta)", "cables alone", "time to the turn"}},
                       {"law.linear_spring_dashpot",
                        {"speed after the impact", "order of the speed", "to the rigid limit"}},
                       {"law.tension_only", {"cables alone", "curve v^2(theta)"}},
                       {"end_rule.attractive", {"attractive", "as the report prints it"}},
                       {"end_rule.clamped", {"clamped"}},
                       {"method.resultant", {"speed after the impact", "order of the speed"}},
                       {"shape.circle", {"speed after the impact"}},
                       {"integrator.central_difference", {"order of the speed", "speed after the impact"}},
                       {"integrator.velocity_verlet", {"cables alone"}},
                       {"integrator.odeint_dopri5", {"to the rigid limit"}}},
      .main_checks = {"speed after the impact, attractive", "distance, attractive", "angle, as the report prints it",
                      "time to the turn, attractive", "order of the time of travel, cables alone"},
      .source = "Mustoe & Huttelmaier 1993, section 5, validation problem 1, Eqs. 26-27",
          .page = page,
          .faults = {{"mass_halved", "the particle has half its mass", "distance, attractive"},
                     {"cable_stiffness_per_length", "the cable's stiffness is divided by its length",
                      "distance, attractive"},
                     {"wrong_end_rule", "the contact never pulls", "distance, as the report prints it"},
                     {"dashpot_halved", "Eq. 21 without its factor 2", "speed after the impact, attractive"},
                     {"euler_cromer", "velocities and positions half a step apart",
                      "order of the time of travel, cables alone"}},
          .tier = Tier::quick,
          .time_limit = 60.0,
          .run = run};
}

}  // namespace talus::verification::problems
