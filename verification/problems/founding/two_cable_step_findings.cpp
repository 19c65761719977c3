#include "verification/problems/founding/two_cable_step_findings.hpp"

#include <cmath>
#include <string>

#include "verification/problems/founding/two_cable_impact.hpp"
#include "verification/reference/restitution.hpp"
#include "verification/study/followed_impact.hpp"
#include "verification/study/leapfrog_impact_error.hpp"
#include "verification/study/phases.hpp"

namespace talus::verification::problems {
namespace {

const reference::TwoCable problem{};

/// Error of the speed after the contact against the soft reference, root mean square over the phases at which the
/// surfaces can meet within a step, against the step.
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

/// Order and constant under one end rule; its curve, the step in contact times.
Series speed_error_curve(EndRule rule, Findings& findings, const Setup& setup) {
  const bool attractive = rule == EndRule::attractive;
  const std::string name = attractive ? "attractive" : "clamped";
  const Convergence errors = speed_errors(rule, setup.coarse ? 3 : 6, setup, findings);
  findings.expect_order(
      "order of the speed, " + name, errors, 0.95, 1.05,
      "a force jump 2 xi m w0 v0 met anywhere within a step leaves an impulse error of first order; at the "
      "coarsest step, w h = .2, the second order adds about w h/4 of it, which tilts the fit by .03");
  const double w = std::sqrt(contact_stiffness / reduced_mass());
  const double xi = reference::damping_ratio(problem.restitution, reference::EndRule::attractive);
  const double predicted = leapfrog_impact_error(xi, same(rule)).restitution * w * particle_share() *
                           reference::restitution(xi, same(rule)) * problem.approach_speed;
  findings.expect(
      "constant of the speed's error, " + name, errors.errors().back() / (predicted * errors.steps().back()), 1.0,
      Tolerance::model(
          attractive ? 0.05 : 0.01,
          "predicted from the lag of the dashpot and its jumps: 64 phases of the clamped "
          "contact's one jump stand for all within 1 %, 64 pairs for the attractive contact's two within 5 %"));
  const auto exact = reference::soft_impact(problem, soft_contact(contact_stiffness, {rule, EndRule::attractive}));
  Series series{.label = name, .x = {}, .y = errors.errors()};
  for (const double step : errors.steps())
    series.x.push_back(step / exact.at_end.t);
  return series;
}

}  // namespace

void check_contact_at_fixed_stiffness(Findings& findings, const Setup& setup) {
  Figure figure{
      .name = "speed_error",
      .title = "Speed after the contact, error against the soft reference",
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

}  // namespace talus::verification::problems
