#include "verification/problems/founding/pivoted_step_findings.hpp"

#include <fmt/format.h>

#include <string>

#include "verification/check/convergence.hpp"
#include "verification/reference/restitution.hpp"
#include "verification/study/expectations.hpp"
#include "verification/study/leapfrog_impact_error.hpp"
#include "verification/study/phases.hpp"
#include "verification/study/pivoted_impact.hpp"
#include "verification/study/predicted_errors.hpp"

namespace talus::verification::problems {
namespace {

const reference::PivotedCylinder problem{};

/// Error of v1 [ft/s] for a relative error of e.
double speed_error(double of_restitution) {
  return problem.approach_speed * problem.restitution * of_restitution * impact_mass() /
         reference::effective_column_mass(problem);
}

/// Over 64 phases of the touch, with a step of its own each.
struct PhaseErrors {
  PhaseError v1, V1;  // [ft/s]
  PhaseError depth;   // relative
};

PhaseErrors errors_at(double n, PivotedRun run, const reference::PivotedSoftImpact& soft, const Setup& setup,
                      Findings& findings) {
  PhaseErrors errors;
  for (const Phase& phase : offset_phases(soft.at_end.t, n)) {
    run.gap = phase.lead() * problem.approach_speed;
    const AfterImpact after = impact(run, VelocityVerlet{}, phase.step, setup, findings);
    errors.v1.add(after.column - soft.column_speed);
    errors.V1.add(after.rock - soft.at_end.rock_vx);
    errors.depth.add(after.largest_overlap / soft.largest_depth - 1.0);
  }
  return errors;
}

Tolerance near_prediction(EndRule rule) {
  return (rule == EndRule::attractive
              ? Tolerance::model(
                    0.10,
                    "predicted from the half-step lag and the force jumps, for the rigid column; its turning "
                    "and the next power of the step make 3 %, the end's jump at 64 uneven phases 6 %")
              : Tolerance::model(
                    0.03,
                    "predicted from the half-step lag and the force jump, for the rigid column; its turning, "
                    ".02 rad, and the next power of the step, w h = .6 %, make 3 %"))
      .relative();
}

/// The errors at n steps per contact beside those predicted of v1 [ft/s] and of the overlap (relative).
void check_errors(const PhaseErrors& errors, const PivotedRun& run, double n, double predicted_v1,
                  double predicted_depth, Findings& findings) {
  const std::string name = run.rule == EndRule::attractive ? "attractive" : "clamped";
  const Tolerance near = near_prediction(run.rule);
  findings.expect(fmt::format("rms error of v1, {:g} steps per contact, {}", n, name), errors.v1.rms(), predicted_v1,
                  near, "ft/s");
  const double of_rock = reference::effective_column_mass(problem) / problem.rock_mass;
  const double rock = errors.V1.rms() / (predicted_v1 * of_rock);
  const double overlap = errors.depth.rms() / predicted_depth;
  findings.expect(
      fmt::format("rms errors of V1 and overlap over the predicted, farther one, {:g} steps per contact, {}", n, name),
      farther_from_one(rock, overlap), 1.0, near);
}

}  // namespace

void check_step(Findings& findings, const Setup& setup) {
  Figure figure{.name = "step_error",
                .title = "Error of the column's speed against the step",
                .caption =
                    "Velocity Verlet, $k_n = 2\\cdot10^5$ lbf/ft: root mean square over 64 phases of the touch, "
                    "against the soft reference. Lines: the error predicted from lag and force jumps; nothing is "
                    "fitted.",
                .x = {.label = "step / contact time", .log = true},
                .y = {.label = "error of v1", .unit = "ft/s", .log = true}};
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    const std::string name = rule == EndRule::attractive ? "attractive" : "clamped";
    const PivotedRun run{.rule = rule};
    const reference::PivotedSoftImpact soft = reference::soft_impact(problem, contact_of(run));
    const double time = soft.at_end.t;
    const ImpactError predicted = leapfrog_impact_error(damping_ratio_of(run), contact_of(run).end);
    Convergence column;
    PredictedErrors drawn;
    PhaseErrors errors;
    for (const double n : doublings(16.0, setup.coarse ? 3 : 6)) {
      errors = errors_at(n, run, soft, setup, findings);
      column.add(time / n, errors.v1.rms());
      drawn.add(1.0 / n, errors.v1.rms(), speed_error(predicted.restitution * frequency_of(run) * time / (n + 0.5)));
    }
    findings.expect_order("order of v1, " + name, column, 0.93, 1.07,
                          "the dashpot's force jumps at touch, a step resolves the jump to half a step");
    const Series points = drawn.points(name + ", solver"), line = drawn.line(name + ", predicted");
    const double n = 1.0 / points.x.back();
    check_errors(errors, run, n, line.y.back(), predicted.largest_depth * (frequency_of(run) * time / (n + 0.5)),
                 findings);
    figure.series.insert(figure.series.end(), {points, line});
    if (figure.slopes.empty()) figure.slopes.push_back({1.0, points.x.front(), 0.5 * points.y.front(), "h"});
  }
  findings.figure(figure);
}

}  // namespace talus::verification::problems
