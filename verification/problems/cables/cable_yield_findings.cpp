#include "verification/problems/cables/cable_findings.hpp"
#include "verification/reference/cables/cable_draw.hpp"
#include "verification/study/scenes/cable_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

constexpr double stiffness = 1.0, mass = 1.0, yield = 0.5;
constexpr double half_swing = std::numbers::pi;  // half a period of the mass on the elastic cable

/// The three cables: perfectly plastic, with linear hardening, with a hardening table.
reference::YieldingCable flat() { return {stiffness, {{0.0, yield}}, 0.0}; }
reference::YieldingCable line() { return {stiffness, {{0.0, yield}}, 0.25}; }
reference::YieldingCable table() { return {stiffness, {{0.0, yield}, {0.5, 0.75}, {1.5, 0.75}, {2.0, 1.25}}, 0.1}; }

/// The solver's law for this cable, with the fault of the setup.
ElasticPlastic law_of(const reference::YieldingCable& cable, const Setup& setup) {
  ElasticPlastic law{.stiffness = cable.stiffness, .yield = cable.points.front().force, .hardening = cable.last_slope};
  for (std::size_t i = 1; i < cable.points.size(); ++i)
    law.table.push_back({cable.points[i].stretch, cable.points[i].force});
  if (setup.has("never_yields")) return ElasticPlastic{.stiffness = cable.stiffness};
  if (setup.has("without_hardening")) return ElasticPlastic{.stiffness = cable.stiffness, .yield = law.yield};
  return law;
}

/// Rms relative error of the exit speed from an elastic cable: (w h)^2/(2 sqrt(90)), as of an elastic impact.
double elastic_error(double count) { return std::pow(half_swing / (count + 0.5), 2) / (2.0 * std::sqrt(90.0)); }
constexpr const char* exit_reason =
    "as for an elastic impact, (w h)^2/(2 sqrt(90)), from the fractions of a step at which the cable becomes taut and "
    "slack";

/// Rms error of the plastic stretch after throws with this sum of squared speeds [L].
double stretch_error(double count, double squares) {
  return std::pow(half_swing / (count + 0.5), 2) * mass * squares / (2.0 * std::sqrt(30.0) * yield);
}
constexpr const char* stretch_reason =
    "if the cable becomes taut at the fraction u of a step, the energy error is (w h)^2 u (1 - u) of m v^2/2, rms "
    "including its mean (w h)^2/sqrt(30); divided by the yield force it is an error of the stretch, reduced because "
    "velocity Verlet's spring is softer, and summed over the throws";

/// Runs successive throws, each with the plastic stretch that the previous one produced. All start the fraction `phase`
/// of a step before the cable is taut.
std::vector<CableRunResult> throws(const ElasticPlastic& law, const std::vector<double>& speeds, double step,
                                   double phase, const Setup& setup, Findings& findings, bool watched = false) {
  std::vector<CableRunResult> runs;
  const Scene scene = thrown_mass(law, mass, 1.0);
  State state = scene.initial;
  for (const double speed : speeds) {
    if (setup.has("stretch_forgotten")) state.z[0] = 0.0;
    state.t = 0.0;
    state.q[0] = cable_length + state.z[0] - phase * step * speed;
    state.v[0] = speed;
    runs.push_back(run_cables(scene, state, VelocityVerlet{}, {step, 40.0, true, watched}, findings));
    state = runs.back().end;
  }
  return runs;
}

/// Number of phases of a root mean square: fewer if only a fault must be detected.
std::size_t phases(const Setup& setup) { return setup.coarse ? 16 : fewest_phases; }

/// Errors of a throw over 64 phases; that of the exit speed is relative.
struct DrawErrors {
  PhaseError exit, stretch, lost;
  double balance_error{};  ///< energy balance error, rms
};

DrawErrors draw_errors(const reference::YieldingCable& cable, double speed, double count, const Setup& setup,
                       Findings& findings) {
  const reference::CableDraw exact = reference::draw(cable, mass, speed);
  DrawErrors errors;
  PhaseError balance_error;
  for (const auto& [i, step, phase] : offset_phases(half_swing, count)) {
    const CableRunResult run = throws(law_of(cable, setup), {speed}, step, phase, setup, findings).front();
    errors.exit.add(-run.end.v[0] / exact.exit_speed - 1.0);
    errors.stretch.add(run.end.z[0] - exact.stretch);
    errors.lost.add(recorded_work(run.end, Mechanism::cable_yield) - exact.lost);
    balance_error.add(run.balance_error);
  }
  errors.balance_error = balance_error.rms();
  return errors;
}

/// Speed of the mass when the cable begins to yield.
double speed_at_yield(double speed) { return std::sqrt(speed * speed - yield * yield / (stiffness * mass)); }

void check_orders(Findings& findings, const Setup& setup) {
  const double speed = 2.0 * yield;
  Convergence exit, stretch, balance_error;
  double last = 0.0, step = 0.0;
  for (const double count : doublings(16.0, 4)) {
    step = half_swing / (count + 0.5);
    const DrawErrors errors = draw_errors(flat(), speed, count, setup, findings);
    exit.add(step, errors.exit.rms());
    stretch.add(step, errors.stretch.rms());
    balance_error.add(step, errors.balance_error);
    last = errors.balance_error;
  }
  findings.expect_order({"plastic/order_of_exit", "order of the exit speed, perfectly plastic"}, exit, 1.85, 2.15,
                        "yield and turning point each lie within a step, which causes errors of second order");
  findings.expect_order({"plastic/order_of_stretch", "order of the residual stretch, perfectly plastic"}, stretch, 1.85,
                        2.15, "as for the exit speed");
  findings.expect_order({"yield_balance/order", "order of the energy balance error, yielding cable"}, balance_error,
                        0.95, 1.05, "the work of yielding is computed with the velocity of half a step before");
  findings.expect_model({"yield_balance/error", "energy balance error over its prediction, yielding cable"},
                        last / (step * yield * speed_at_yield(speed) / std::sqrt(3.0)), 1.0, 0.03,
                        "the velocity of half a step before is too large by h Y/(2 m), which gives h Y v1/2 with the "
                        "speed v1 at the onset of yielding; the step of the onset adds an error uniformly distributed "
                        "in +-h Y v1/2: rms h Y v1/sqrt(3); the next order in h is 2 % of this");
  findings.figure(
      {.name = "yield_orders",
       .title = "Convergence with the step for a mass thrown on a yielding cable",
       .caption = "Perfectly plastic cable, twice the lowest speed at which it yields, velocity Verlet, root mean "
                  "square over 64 phases.",
       .x = {.label = "w h", .log = true},
       .y = {.label = "error", .log = true},
       .series = {{"exit speed, relative", exit.steps(), exit.errors(), Style::linespoints},
                  {"residual stretch [m]", stretch.steps(), stretch.errors(), Style::linespoints},
                  {"energy balance error [J]", balance_error.steps(), balance_error.errors(), Style::linespoints}},
       .slopes = {{2.0, exit.steps().front(), 0.4 * exit.errors().front(), "h^2"},
                  {1.0, balance_error.steps().front(), 1.6 * balance_error.errors().front(), "h"}}});
}

/// Throws just below and above the lowest speed at which the cable yields, and far from it.
void check_speeds(Findings& findings, const Setup& setup) {
  const double limit = yield / std::sqrt(stiffness * mass);
  double exit = 0.0, stretch = 0.0;
  Table shown{.name = "throws",
              .caption =
                  "Throws on a perfectly plastic cable: exit speed, exactly the smaller of $v$ and $Y/\\sqrt{km}$, "
                  "with the relative error of the solver, and residual stretch; 400 steps per half-period of the "
                  "elastic cable, 64 phases.",
              .columns = {"v sqrt(km)/Y", "exit speed", "solver, rms error", "stretch [m]", "solver, rms error"}};
  for (const double ratio : {0.5, 0.999, 1.001, 1.5, 2.0, 4.0}) {
    if (setup.coarse && ratio != 2.0) continue;
    const reference::CableDraw exact = reference::perfectly_plastic_draw(stiffness, yield, mass, ratio * limit);
    const DrawErrors errors = draw_errors(flat(), ratio * limit, 400.0, setup, findings);
    keep_largest(exit, errors.exit.rms());
    keep_largest(stretch, errors.stretch.rms());
    if (ratio == 0.999) {
      findings.expect_exact(
          {"yield_limit/below", "residual stretch at 0.999 times the lowest speed at which the cable yields"},
          errors.stretch.max(), 0.0, "a cable that never reaches its yield force has no plastic stretch", "m");
    } else if (ratio == 1.001) {
      findings.expect_true(
          {"yield_limit/above", "residual stretch at 1.001 times the lowest speed at which the cable yields"},
          errors.stretch.max() < exact.stretch,
          "the error of velocity Verlet's peak tension, (w h)^2/8 = 8e-6, is about 1 % of the margin of 0.001");
    }
    shown.rows.push_back(cells("{:g} | {:.6f} | {:.1e} | {:.6f} | {:.1e}", ratio, exact.exit_speed, errors.exit.rms(),
                               exact.stretch, errors.stretch.rms()));
  }
  findings.expect_truncation(
      {"plastic/exit", "exit speed, perfectly plastic, largest rms relative error of six speeds"}, exit, 0.0,
      elastic_error(400.0), 1.2, exit_reason);
  findings.expect_truncation(
      {"plastic/stretch", "residual stretch, perfectly plastic, largest rms error of six speeds"}, stretch, 0.0,
      stretch_error(400.0, std::pow(4.0 * limit, 2)), 1.0, stretch_reason, "m");
  if (!setup.coarse) findings.table(shown);
}

/// Figure of tension against elongation over successive throws, solver and exact.
Figure loops(const std::string& name, const std::string& title, const std::string& caption,
             const reference::YieldingCable& cable, const std::vector<CableRunResult>& runs,
             const std::vector<reference::CableDraw>& exact) {
  Series lines{"exact", {}, {}, Style::lines}, points{"solver", {}, {}, Style::points};
  double stretch = 0.0;
  const auto to = [&](double e, double t) { lines.add(e, t); };
  to(0.0, 0.0);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    to(stretch, 0.0);
    if (exact[i].stretch > stretch) {
      to(reference::yield_elongation(cable, stretch), reference::yield_force(cable, stretch));
      for (const auto& corner : cable.points) {
        if (corner.stretch > stretch && corner.stretch < exact[i].stretch)
          to(reference::yield_elongation(cable, corner.stretch), corner.force);
      }
    }
    to(exact[i].stretch + exact[i].peak_tension / stiffness, exact[i].peak_tension);
    to(exact[i].stretch, 0.0);
    stretch = exact[i].stretch;
    for (std::size_t j = 0; j < runs[i].time.size(); j += 20)
      points.add(runs[i].elongation[j], runs[i].tension[j]);
  }
  return {.name = name,
          .title = title,
          .caption = caption,
          .x = {.label = "elongation", .unit = "m"},
          .y = {.label = "tension", .unit = "N"},
          .series = {lines, points}};
}

/// Successive throws on one cable: total work of yielding, residual stretch, and exit speed of the last throw.
void check_cycles(Findings& findings, const Setup& setup, const std::string& stem, const std::string& name,
                  const reference::YieldingCable& cable, const std::vector<double>& speeds) {
  std::vector<reference::CableDraw> exact;
  double stretch = 0.0, lost = 0.0, squares = 0.0, work = 0.0;
  for (const double speed : speeds) {
    exact.push_back(reference::draw(cable, mass, speed, stretch));
    const double from = reference::yield_force(cable, stretch);
    const double v1 = std::sqrt(std::max(0.0, speed * speed - from * from / (stiffness * mass)));
    work += half_swing / 200.5 * v1 * (from / std::sqrt(3.0) + 0.25 * (exact.back().peak_tension - from));
    squares += speed * speed;
    stretch = exact.back().stretch;
    lost += exact.back().lost;
  }
  PhaseError yield_work, residual, exit;
  for (std::size_t i = 0; i < phases(setup); ++i) {
    const double step = offset_step(half_swing, 200.0, i);
    const auto runs = throws(law_of(cable, setup), speeds, step, even_phases(phases(setup))[i], setup, findings);
    yield_work.add(recorded_work(runs.back().end, Mechanism::cable_yield) / lost - 1.0);
    residual.add(runs.back().end.z[0] - stretch);
    exit.add(-runs.back().end.v[0] / exact.back().exit_speed - 1.0);
  }
  findings.expect_truncation(
      {"work_of_throws/" + name, "work of yielding over " + name + ", rms relative error"}, yield_work.rms(), 0.0,
      work / lost, 1.1,
      "for each throw, h times Y v1/sqrt(3), as for a perfectly plastic cable, plus h times half the growth of the "
      "yield force at the mean speed v1/2; 10 % more because the phases of successive throws are correlated");
  findings.expect_truncation({"residual_stretch/" + name, "residual stretch after " + name + ", rms error"},
                             residual.rms(), 0.0, stretch_error(200.0, squares), 1.0, stretch_reason, "m");
  findings.expect_truncation({"exit_speed/" + name, "exit speed after " + name + ", rms relative error"}, exit.rms(),
                             0.0, elastic_error(200.0), 1.2, exit_reason);
  if (setup.coarse) return;
  const double step = offset_step(half_swing, 200.0, 0);
  findings.figure(loops(stem, "Tension and elongation: " + name,
                        "Tension against elongation. Each throw starts with the plastic stretch of the previous one. "
                        "Points: solver; lines: exact.",
                        cable, throws(law_of(cable, setup), speeds, step, 0.5, setup, findings, true), exact));
}

}  // namespace

void check_yielding(Findings& findings, const Setup& setup) {
  check_speeds(findings, setup);
  if (!setup.coarse) check_orders(findings, setup);
  check_cycles(findings, setup, "plastic_loop", "two throws, perfectly plastic", flat(), {1.0, 1.2});
  check_cycles(findings, setup, "line_loop", "two throws, linear hardening", line(), {1.0, 1.6});
  check_cycles(findings, setup, "table_loop", "three throws, tabulated hardening", table(), {0.9, 1.2, 1.9});
}

}  // namespace talus::verification::problems
