#include "verification/study/impacts/pivoted_impact.hpp"

#include <cmath>

#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/impacts/followed_impact.hpp"

namespace talus::verification::problems {
namespace {

const reference::PivotedCylinder problem{};

/// 2 w0^2 = m g l/I_p: theta'' = -(m g l/2 I_p) sin theta.
double weight_factor() {
  return problem.mass * problem.gravity * problem.length / reference::inertia_about_pin(problem);
}

}  // namespace

double impact_mass() {
  return reference::effective_mass(1.0 / problem.rock_mass, 1.0 / reference::effective_column_mass(problem));
}

double damping_ratio_of(const PivotedRun& run) {
  const reference::PivotedContact contact = contact_of(run);
  return contact.damping / (2.0 * std::sqrt(contact.stiffness * impact_mass()));
}

double frequency_of(const PivotedRun& run) { return std::sqrt(run.stiffness / impact_mass()); }

reference::PivotedContact contact_of(const PivotedRun& run) {
  const double mass = run.dashpot == Dashpot::two_masses
                          ? reference::effective_mass(1.0 / problem.rock_mass, 1.0 / problem.mass)
                          : impact_mass();
  const double xi =
      reference::damping_ratio(problem.restitution, run.eq_21 ? reference::EndRule::attractive : same(run.rule));
  return {run.stiffness, dashpot_of(xi, run.stiffness, mass, run.rule).damping, same(run.rule)};
}

Scene scene_of(const PivotedRun& run, const Setup& setup) {
  PivotedRun given = run;
  if (setup.has("two_masses")) given.dashpot = Dashpot::two_masses;
  const reference::PivotedContact contact = contact_of(given);
  const EndRule rule = setup.has("clamped") ? EndRule::clamped : run.rule;
  scenes::PivotedCylinder parameters{.mass = problem.mass,
                                     .length = problem.length,
                                     .inertia = problem.inertia,
                                     .half_width = problem.half_width,
                                     .rock_mass = problem.rock_mass,
                                     .rock_radius = problem.rock_radius,
                                     .speed = problem.approach_speed,
                                     .gravity = run.gravity ? problem.gravity : 0.0,
                                     .contact = LinearSpringDashpot{contact.stiffness, contact.damping, rule},
                                     .method = run.method};
  if (setup.has("column_mass_halved")) parameters.mass *= 0.5;
  if (setup.has("gravity_doubled")) parameters.gravity *= 2.0;
  Scene scene = scenes::pivoted_cylinder(parameters);
  const double before = run.gap / problem.approach_speed;
  scene.initial.q[1] -= run.gap;
  scene.initial.q[2] -= 0.5 * parameters.gravity * before * before;
  scene.initial.v[2] += parameters.gravity * before;
  return scene;
}

AfterImpact impact(const PivotedRun& run, const Integrator& integrator, double step, const Setup& setup,
                   Findings& findings) {
  Scene scene = scene_of(run, setup);
  scene.integrator = integrator;
  const double touch = run.gap / problem.approach_speed;
  const double longest = 20.0 * std::sqrt(impact_mass() / run.stiffness);
  scene.plan = {step, touch + longest, longest, false};
  const FollowedImpact found = follow_impact(scene, findings);
  AfterImpact after;
  const double theta = found.at_end.q[0];
  const double rate = found.at_end.v[0];
  // Extrapolated back by less than a step, with the moment of the weight at the half-way angle.
  const double past = found.at_end.t - found.end_time;
  const double weight = run.gravity ? 0.5 * weight_factor() : 0.0;
  after.column = 0.5 * problem.length * (rate + past * weight * std::sin(theta - 0.5 * past * rate));
  after.rock = found.at_end.v[1];
  after.largest_angle =
      2.0 * std::asin(std::sqrt(rate * rate / (2.0 * weight_factor()) + std::pow(std::sin(0.5 * theta), 2)));
  after.largest_overlap = found.largest_depth;
  after.end_time = found.end_time - touch;
  after.at_end = found.at_end;
  return after;
}

AfterImpact converged_impact(const PivotedRun& run, const Setup& setup, Findings& findings) {
  const double step = converged_interval * std::sqrt(impact_mass() / run.stiffness);
  return impact(run, make_integrator("odeint_dopri5", 1e-12), step, setup, findings);
}

}  // namespace talus::verification::problems
