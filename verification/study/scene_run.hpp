#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "solver/run/simulate.hpp"
#include "solver/scenes/scene.hpp"

/// A scene run for a given number of equal steps, and times of passage through a coordinate's zero, as the solver gives
/// them.
namespace talus::verification::problems {

struct RunEnd {
  State state{};       ///< synchronised, at the end
  long evaluations{};  ///< of the forces
};

/// Runs `steps` steps of length `step` from the scene's start; the ledger is left off. A run that diverges ends in a
/// state that is not finite, so that no check passes on it.
inline RunEnd run_steps(const Scene& scene, Integrator integrator, double step, long steps,
                        std::span<const Observer> observers = {}) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, false};
  RunEnd end{scene.initial, 0};
  const RunPlan plan{.step = step, .end = step * static_cast<double>(steps), .interval = step, .ledger = false};
  const Outcome outcome = simulate(system, integrator, end.state, plan, observers);
  if (!outcome) end.state.q.assign(end.state.q.size(), std::numeric_limits<double>::quiet_NaN());
  end.evaluations = system.evaluations();
  return end;
}

/// Where the cubic through four values, one step apart, falls or rises through zero between the second and the third,
/// in steps from the second. Positions alone are used: the velocities of a method are not the rates of the curve on
/// which its positions lie. The error is of order step^5 where the second derivative vanishes with the value, as at
/// the bottom of a swing.
inline double zero_of_cubic(const std::array<double, 4>& q) {
  const auto value = [&](double s) {
    return -q[0] * s * (s - 1.0) * (s - 2.0) / 6.0 + q[1] * (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0 -
           q[2] * (s + 1.0) * s * (s - 2.0) / 2.0 + q[3] * (s + 1.0) * s * (s - 1.0) / 6.0;
  };
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 53; ++i) {
    const double middle = 0.5 * (low + high);
    (std::signbit(value(middle)) == std::signbit(q[1]) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Time between the first and the third passage of the scene's first coordinate through zero, steps of length `step`;
/// NaN if there are none within `most` [T].
inline double period_of(const Scene& scene, Integrator integrator, double step, double most) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, false};
  State state = scene.initial;
  std::vector<double> passages;  // in steps
  std::array<double, 4> q{};
  long seen = 0;
  const StopCondition third = [&](const State& now) {
    q = {q[1], q[2], q[3], now.q[0]};
    ++seen;
    if (seen >= 4 && std::signbit(q[1]) != std::signbit(q[2]))
      passages.push_back(static_cast<double>(seen - 2) + zero_of_cubic(q));
    return passages.size() == 3;
  };
  const RunPlan plan{.step = step, .end = most, .interval = step, .ledger = false};
  const Outcome outcome = simulate(system, integrator, state, plan, {}, third);
  if (!outcome || passages.size() != 3) return std::numeric_limits<double>::quiet_NaN();
  return (passages[2] - passages[0]) * step;
}

}  // namespace talus::verification::problems
