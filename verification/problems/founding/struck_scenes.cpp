#include "verification/problems/founding/struck_scenes.hpp"

#include <cmath>
#include <numbers>

#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/scenes/two_cable.hpp"
#include "verification/reference/cables/two_cable_contact.hpp"
#include "verification/reference/impacts/pivoted_cylinder.hpp"
#include "verification/reference/impacts/restitution.hpp"

namespace talus::verification::problems {
namespace {

using std::numbers::pi;

double fraction(double x) { return x - std::floor(x); }

/// rms over u in (0, 1) of f(u - offset) - f(u), by the midpoint rule.
double rms_of_difference(double (*f)(double), double offset) {
  constexpr int points = 4000;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double u = (i + 0.5) / points;
    const double difference = f(fraction(u - offset)) - f(u);
    sum += difference * difference;
  }
  return std::sqrt(sum / points);
}

/// The same, rms also over all offsets.
double rms_of_difference(double (*f)(double)) {
  constexpr int offsets = 64;
  double sum = 0.0;
  for (int i = 0; i < offsets; ++i)
    sum += std::pow(rms_of_difference(f, (i + 0.5) / offsets), 2.0);
  return std::sqrt(sum / offsets);
}

double leapfrog_ramp(double u) { return 0.5 * u * (1.0 - u); }
double rk4_ramp(double u) { return u / 6.0 + (2.0 / 3.0) * std::max(u - 0.5, 0.0) - 0.5 * u * u; }

}  // namespace

PhasedImpact struck_disc(const StruckDisc& disc) {
  const double w = std::sqrt(disc.stiffness / disc.mass);
  const double c = 2.0 * disc.damping_ratio * disc.mass * w;
  const auto events = reference::impact_events({disc.stiffness, c, disc.mass, disc.speed}, reference::EndRule::clamped);
  const LinearSpringDashpot law{disc.stiffness, disc.without_dashpot ? 0.0 : c, EndRule::clamped};
  PhasedImpact impact{
      .at_touch = scenes::bouncing_disc({.mass = disc.mass, .radius = 0.1, .speed = disc.speed, .contact = law}),
      .contact_time = events.contact_time,
      .watch = 1.0,
      .observed = 1,
      .taken_back = [](State& state, double t) { state.q[1] -= t * state.v[1]; },
      .exact = {}};
  const double exit = events.restitution * disc.speed;
  impact.exact = [exit](std::span<const double> times) { return std::vector<double>(times.size(), exit); };
  return impact;
}

PhasedImpact struck_cables(double restitution, double mass_factor) {
  reference::TwoCable problem;
  problem.restitution = restitution;
  const double m = problem.mass * problem.striker_mass / (problem.mass + problem.striker_mass);
  const reference::SoftContact contact{4e4, reference::eq_21_damping(restitution, 4e4, m),
                                       reference::EndRule::attractive};
  PhasedImpact impact{.at_touch = scenes::two_cable(
                          {.mass = problem.mass * mass_factor,
                           .contact = LinearSpringDashpot{contact.stiffness, contact.damping, EndRule::attractive}}),
                      .contact_time = reference::impact_events(
                                          {contact.stiffness, contact.damping, m, problem.approach_speed}, contact.end)
                                          .contact_time,
                      .watch = 1.3,
                      .observed = 0,
                      .taken_back = [](State& state, double t) { state.q[2] -= t * state.v[2]; },
                      .exact = {}};
  impact.exact = [problem, contact](std::span<const double> times) {
    std::vector<double> values;
    for (const auto& sample : reference::soft_impact(problem, contact, times).samples)
      values.push_back(sample.particle_velocity);
    return values;
  };
  return impact;
}

PhasedImpact struck_column(double restitution) {
  reference::PivotedCylinder problem;
  problem.restitution = restitution;
  const double k = 1e6;
  const reference::PivotedContact contact{k, reference::pivoted_damping(problem, k), reference::EndRule::attractive};
  const double m = reference::effective_mass(1.0 / problem.rock_mass, 1.0 / reference::effective_column_mass(problem));
  const double g = problem.gravity;
  PhasedImpact impact{
      .at_touch = scenes::pivoted_cylinder({.rock_radius = problem.rock_radius,
                                            .gravity = g,
                                            .contact = LinearSpringDashpot{k, contact.damping, EndRule::attractive}}),
      .contact_time =
          reference::impact_events({k, contact.damping, m, problem.approach_speed}, contact.end).contact_time,
      .watch = 1.3,
      .observed = 0,
      // The rock rises on its parabola to the height of G at touch; the column hangs at rest.
      .taken_back =
          [g](State& state, double t) {
            state.q[1] -= t * state.v[1];
            state.q[2] -= 0.5 * g * t * t;
            state.v[2] += g * t;
          },
      .exact = {}};
  impact.exact = [problem, contact](std::span<const double> times) {
    std::vector<double> values;
    for (const auto& sample : reference::soft_impact(problem, contact, times).samples)
      values.push_back(sample.rate);
    return values;
  };
  return impact;
}

double leapfrog_elastic_constant(double offset) {
  return pi * pi * offset * (1.0 - offset) / (2.0 * std::numbers::sqrt3);
}
double leapfrog_elastic_constant() { return pi * pi * rms_of_difference(leapfrog_ramp); }
double rk4_elastic_constant(double offset) { return pi * pi * rms_of_difference(rk4_ramp, offset); }
double rk4_elastic_constant() { return pi * pi * rms_of_difference(rk4_ramp); }

double rk4_damped_constant(double damping_ratio, reference::EndRule end) {
  const double jumps = end == reference::EndRule::attractive ? 2.0 : 1.0;
  return 2.0 * damping_ratio / 6.0 * std::sqrt(jumps);
}

}  // namespace talus::verification::problems
