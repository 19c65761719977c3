#include "verification/problems/speed_accuracy/highest_mode.hpp"

#include <cmath>
#include <limits>

#include "solver/run/simulate.hpp"

namespace talus::verification::problems {
namespace {

/// The state moved by so much along a shape of the coordinates, then at rest.
State moved(RigidBodySystem& system, const State& rest, const std::vector<double>& shape, double distance) {
  State state = rest;
  state.v = shape;
  system.drift(state, distance);
  state.v.assign(state.v.size(), 0.0);
  return state;
}

/// Of two sets of coordinates, the sum of inertia times both.
double product(const Dynamics& dynamics, const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += dynamics.inertias()[i] * a[i] * b[i];
  return sum;
}

}  // namespace

HighestMode highest_mode(const Dynamics& dynamics, const State& rest, double distance, int iterations) {
  RigidBodySystem system{dynamics, false};
  State settled = rest;
  system.begin(settled);
  HighestMode mode;
  for (std::size_t i = 0; i < rest.q.size(); ++i)
    mode.shape.push_back(std::cos(1.0 + 2.4 * static_cast<double>(i)));  // nothing that a scene is orthogonal to
  Rates there{settled}, back{settled};
  for (int n = 0; n < iterations; ++n) {
    const double length = std::sqrt(product(dynamics, mode.shape, mode.shape));
    for (double& x : mode.shape)
      x /= length;
    State ahead = moved(system, settled, mode.shape, distance), behind = moved(system, settled, mode.shape, -distance);
    system.evaluate(ahead, there);
    system.evaluate(behind, back);
    std::vector<double> pull(rest.q.size());
    for (std::size_t i = 0; i < pull.size(); ++i)
      pull[i] = (back.v[i] - there.v[i]) / (2.0 * distance);
    mode.frequency = std::sqrt(product(dynamics, mode.shape, pull));
    if (n + 1 < iterations) mode.shape = pull;
  }
  return mode;
}

double mode_growth(const Dynamics& dynamics, const State& rest, const HighestMode& mode, double start, double step,
                   long steps) {
  RigidBodySystem system{dynamics, false};
  State state = rest;
  system.begin(state);
  state = moved(system, state, mode.shape, start);
  std::vector<double> sizes;
  const Observer watch = [&](const State& seen, const StepInfo&) {
    std::vector<double> way(seen.q.size());
    for (std::size_t i = 0; i < way.size(); ++i)
      way[i] = seen.q[i] - rest.q[i];
    sizes.push_back(
        std::hypot(product(dynamics, mode.shape, way), product(dynamics, mode.shape, seen.v) / mode.frequency));
  };
  const StopCondition done = [&](const State&) { return !sizes.empty() && !(sizes.back() < 1e6 * start); };
  Integrator verlet = VelocityVerlet{};
  const RunPlan plan{.step = step, .end = step * static_cast<double>(steps), .interval = step, .ledger = false};
  (void)simulate(system, verlet, state, plan, {&watch, 1}, done);
  std::size_t from = 0, to = 0;
  bool stays = true;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    stays = stays && sizes[i] <= 1.5 * start;
    if (from == 0 && sizes[i] > 1e2 * start) from = i;
    if (to == 0 && sizes[i] > 1e5 * start) to = i;
  }
  if (stays) return 0.0;
  if (to == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::log(sizes[to] / sizes[from]) / static_cast<double>(to - from);
}

}  // namespace talus::verification::problems
