#include "verification/study/runs/scene_run.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/run/simulate.hpp"

namespace talus::verification::problems {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Zero crossing of the cubic through four values, one step apart, between the second and the third, in steps from the
/// second. Only positions are used: the velocities of a method are not the rates of the curve on which its positions
/// lie. The error is of order step^5 where the second derivative vanishes with the value, as at the bottom of a
/// pendulum.
double zero_of_cubic(const std::array<double, 4>& q) {
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

}  // namespace

RunEnd run_scene(const Scene& scene, Integrator integrator, const RunPlan& plan, Findings* findings,
                 const Watcher& watch, const Until& until) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, plan.ledger};
  RunEnd end{.state = State{scene.initial}};
  std::vector<Observer> observers;
  if (watch) observers.emplace_back(watch);
  RegimeRecorder regimes{scene.model};
  if (is_recording_use())
    observers.emplace_back([&](const Snapshot&, const StepInfo& info) { regimes.see(*info.held); });
  end.finished = static_cast<bool>(simulate(system, integrator, end.state, RunPlan{plan}, observers, until));
  if (!end.finished) {
    end.state.q.assign(end.state.q.size(), not_a_number);
    end.state.v.assign(end.state.v.size(), not_a_number);
  }
  end.evaluations = system.evaluations();
  if (is_recording_use()) {
    record_use(scene.model);
    record_use(integrator);
    record_mechanisms(end.state);
    regimes.record();
  }
  end.method = std::move(integrator);
  if (findings != nullptr) findings->count(end.evaluations);
  return end;
}

RunEnd run_steps(const Scene& scene, Integrator integrator, double step, long steps, Findings* findings,
                 const Watcher& watch) {
  const RunPlan plan{.step = step, .end = step * static_cast<double>(steps), .interval = step, .ledger = false};
  return run_scene(scene, std::move(integrator), plan, findings, watch);
}

double period_of(const Scene& scene, Integrator integrator, double step, double maximum) {
  std::vector<double> passages;  // in steps
  std::array<double, 4> q{};
  long seen = 0;
  const Until third = [&](const State& now) {
    q = {q[1], q[2], q[3], now.q[0]};
    ++seen;
    if (seen >= 4 && std::signbit(q[1]) != std::signbit(q[2]))
      passages.push_back(static_cast<double>(seen - 2) + zero_of_cubic(q));
    return passages.size() == 3;
  };
  const RunPlan plan{.step = step, .end = maximum, .interval = step, .ledger = false};
  const RunEnd end = run_scene(scene, std::move(integrator), plan, nullptr, {}, third);
  return end.finished && passages.size() == 3 ? (passages[2] - passages[0]) * step : not_a_number;
}

State first_state(const Scene& scene) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics};
  State state = scene.initial;
  system.begin(state);
  return state;
}

}  // namespace talus::verification::problems
