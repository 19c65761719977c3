#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/model/model_builder.hpp"
#include "verification/problems/scene_run.hpp"

/// A disc squeezed between two planes: both contacts stay closed, so that the motion about the middle is a bilateral
/// damped oscillator and a method's growth per step is that of a 2 x 2 matrix.
namespace talus::verification::problems {

struct SqueezedDisc {
  double frequency = 100.0;    ///< w of the oscillator [rad/s]: two contacts of k = m w^2/2 each
  double damping_ratio = 0.0;  ///< xi of the oscillator
  double start = 1e-3;         ///< distance from the middle at the start, at rest [m]
};

inline Scene squeezed_disc(const SqueezedDisc& p) {
  constexpr double mass = 1.0;
  constexpr double radius = 1.0;
  constexpr double depth = 0.0625;
  const LinearSpringDashpot law{0.5 * mass * p.frequency * p.frequency, p.damping_ratio * mass * p.frequency,
                                EndRule::attractive};
  ModelBuilder builder{si};
  const BodyId disc = builder.add(
      {.name = "disc", .mobility = Mobility::particle, .mass = mass, .shape = Circle{radius}, .p_WB = {0.0, p.start}});
  const BodyId floor =
      builder.add({.name = "floor", .mobility = Mobility::fixed, .shape = HalfPlane{}, .p_WB = {0.0, depth - radius}});
  const BodyId ceiling = builder.add({.name = "ceiling",
                                      .mobility = Mobility::fixed,
                                      .shape = HalfPlane{},
                                      .p_WB = {0.0, radius - depth},
                                      .angle = std::acos(-1.0)});
  builder.add(Contact{.name = "below", .a = disc, .b = floor, .law = law});
  builder.add(Contact{.name = "above", .a = disc, .b = ceiling, .law = law});
  Scene scene{.title = "Disc squeezed between two planes", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  return scene;
}

/// Distance from rest in phase space after each step, sqrt(x^2 + (v/w)^2) [m]. (The position alone has its node where
/// central difference reports it: with lambda = -1 it is zero at whole steps.)
inline std::vector<double> distances(const SqueezedDisc& disc, const Integrator& integrator, double step, long steps) {
  std::vector<double> all;
  const std::vector<Observer> watch{
      [&](const State& state, const StepInfo&) { all.push_back(std::hypot(state.q[1], state.v[1] / disc.frequency)); }};
  [[maybe_unused]] const RunEnd end = run_steps(squeezed_disc(disc), integrator, step, steps, watch);
  return all;
}

/// ln of the factor by which that distance grows in a step, between the moments at which it has passed 1e-7 and 1e-2
/// from 1e-12; NaN if it does not in 3000 steps.
inline double growth_per_step(SqueezedDisc disc, const Integrator& integrator, double step) {
  disc.start = 1e-12;
  const std::vector<double> all = distances(disc, integrator, step, 3000);
  const auto passed = [&](double mark) {
    return std::find_if(all.begin(), all.end(), [&](double x) { return x > mark; });
  };
  const auto first = passed(1e-7);
  const auto last = passed(1e-2);
  if (last == all.end()) return std::numeric_limits<double>::quiet_NaN();
  return std::log(*last / *first) / static_cast<double>(last - first);
}

/// ln of the factor by which the area W = x_n v_{n+1} - x_{n+1} v_n of two successive states changes in a step: ln of
/// the determinant of the step's matrix, whatever its eigenvalues. Measured over ten early steps: the area of nearly
/// parallel states that shrink loses digits later.
///
/// `rounding` sums up, in quadrature and for that mean, what the roundings of the depth do to the area: each of the two
/// depths is a number below 1 less another, off by 5.5e-17 at most; with half the stiffness each their mean has the
/// standard deviation 5.5e-17/sqrt(6) = 2.3e-17, six of which are d = 1.4e-16. It kicks v/w by w h d, which moves x by
/// (w h)^2 d.
struct AreaChange {
  double logarithm{};
  double rounding{};
};

inline AreaChange area_change_per_step(SqueezedDisc disc, const Integrator& integrator, double step) {
  disc.start = 1e-4;
  std::vector<Vec2> states;
  const std::vector<Observer> watch{[&](const State& state, const StepInfo&) {
    states.push_back({state.q[1], state.v[1] / disc.frequency});
  }};
  [[maybe_unused]] const RunEnd end = run_steps(squeezed_disc(disc), integrator, step, 14, watch);
  const auto area = [&](std::size_t n) { return cross(states[n], states[n + 1]); };
  const double eta = disc.frequency * step;
  AreaChange change{.logarithm = std::log(area(12) / area(2)) / 10.0};
  for (std::size_t n = 2; n < 12; ++n)
    change.rounding = std::hypot(change.rounding, 1.4e-16 * eta * (1.0 + eta) * norm(states[n]) / area(n) / 10.0);
  return change;
}

/// ln |lambda| of the leapfrog with the dashpot on the velocity of half a step before, by eta = w h:
///   v' = v (1 - 2 xi eta) - eta x,  x' = x + eta v'   (v over w);   trace 2 - 2 xi eta - eta^2, determinant 1 - 2 xi
/// eta.  lambda = -1, the limit, is eta^2 + 4 xi eta - 4 = 0.
inline double leapfrog_growth(double xi, double eta) {
  const double trace = 2.0 - 2.0 * xi * eta - eta * eta;
  const double determinant = 1.0 - 2.0 * xi * eta;
  const double root = 0.25 * trace * trace - determinant;
  if (root <= 0.0) return 0.5 * std::log(determinant);
  return std::log(0.5 * std::abs(trace) + std::sqrt(root));
}

/// eta at that limit.
inline double leapfrog_limit(double xi) { return 2.0 * (std::sqrt(1.0 + xi * xi) - xi); }

}  // namespace talus::verification::problems
