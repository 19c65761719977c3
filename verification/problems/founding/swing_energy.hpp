#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "verification/study/scene_run.hpp"
#include "verification/study/swing.hpp"

/// The energy of a swing over many periods.
namespace talus::verification::problems {

/// Relative energy E/E0 - 1 over 1e4 periods: lowest and highest in each hundredth of the run, and at the end.
struct EnergyHistory {
  std::vector<double> lowest = std::vector<double>(100, 0.0);
  std::vector<double> highest = std::vector<double>(100, 0.0);
  double end{};
};

inline EnergyHistory energy_history(const scenes::Pendulum& p, const Integrator& integrator, int per_period,
                                    long periods) {
  const double inertia = p.inertia + p.mass * p.arm * p.arm;
  const double weight = p.mass * p.gravity * p.arm;
  const double half = std::sin(0.5 * p.amplitude);
  const long steps = periods * per_period;
  EnergyHistory history;
  const Watcher watch = [&](const State& s, const StepInfo& info) {
    const double sine = std::sin(0.5 * s.q[0]);
    // Differences of squares: the energy is needed to more digits than its two parts have together.
    history.end =
        (0.5 * inertia * s.v[0] * s.v[0] + 2.0 * weight * (sine - half) * (sine + half)) / (2.0 * weight * half * half);
    const auto window = static_cast<std::size_t>(std::min(99L, info.step * 100 / steps));
    history.lowest[window] = std::min(history.lowest[window], history.end);
    history.highest[window] = std::max(history.highest[window], history.end);
  };
  const double h = 2.0 * std::numbers::pi / bob_frequency() / per_period;
  const RunEnd end = run_steps(scenes::pendulum(p), integrator, h, steps, nullptr, watch);
  if (!std::isfinite(end.state.q[0])) history.end = end.state.q[0];
  return history;
}

}  // namespace talus::verification::problems
