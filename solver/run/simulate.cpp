#include "solver/run/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/base/rows.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/run/run_state.hpp"
#include "solver/run/snapshot.hpp"

namespace talus {
namespace {

/// Index of the first of `count` coordinates whose position or velocity is not finite; `count` if all are finite.
std::size_t first_not_finite(const State& state, std::size_t count) {
  if (all_finite(state.q.data(), state.v.data(), count)) return count;
  std::size_t first = 0;
  while (std::isfinite(state.q[first]) && std::isfinite(state.v[first]))
    ++first;
  return first;
}

Outcome diverged(const RigidBodySystem& system, const State& state, std::size_t coordinate, double h) {
  const Dynamics& dynamics = system.dynamics();
  const std::string time = symbol(dynamics.model().units, dimension::time);
  const std::string which = name(dynamics.model(), dynamics.layout().coordinates[coordinate]);
  return {Outcome::Kind::diverged, state.t,
          fmt::format("diverged at t = {:.6g} {}: '{}' is not finite (step {:.6g} {})", state.t, time, which, h, time)};
}

/// Makes a snapshot follow a run during the lifetime of this object.
class Following {
 public:
  Following(Snapshot* snapshot, std::function<void(State&)> synchronise) : snapshot_{snapshot} {
    if (snapshot_) snapshot_->follow(std::move(synchronise));
  }
  Following(const Following&) = delete;
  Following& operator=(const Following&) = delete;
  ~Following() {
    if (snapshot_) snapshot_->end();
  }

 private:
  Snapshot* snapshot_;
};

/// Continues the run with its integrator, which is of type Method.
template <class Method>
Outcome run(RigidBodySystem& system, Method& method, RunState& run_state, const RunPlan& plan,
            std::span<const Observer> observers, const StopCondition& stop, Snapshot* seen) {
  static_assert(IntegratorFor<Method, RigidBodySystem>);
  const double start = run_state.start;
  const long steps =
      step_count({.step = plan.step, .end = plan.end - start, .interval = plan.interval, .ledger = plan.ledger});
  // The limit avoids integer overflow for intervals longer than any run.
  const long every = std::max(1L, std::lround(std::min(plan.interval / plan.step, 1e15)));
  const long before = run_state.evaluations - system.evaluations();
  State& state = run_state.state;
  // Without observers and stop condition, no snapshot is prepared.
  std::optional<Snapshot> own;
  if (!observers.empty() || stop) {
    if (!seen) seen = &own.emplace(system.dynamics());
  } else {
    seen = nullptr;
  }
  if (run_state.step == 0) {
    system.begin(state);
    if (seen) seen->set(state);
    for (const Observer& observe : observers)
      observe(*seen, {0, before + system.evaluations(), true, false, false, &state});
    method.start(system, state, plan.step);
  }
  const Following following{seen, [&](State& copy) {
                              copy_numbers(state, copy);
                              synchronize(method, system, copy, plan.step);
                            }};
  while (run_state.step < steps) {
    method.step(system, state, plan.step);
    if constexpr (requires { method.failure(); }) {
      if (!method.failure().empty()) return {Outcome::Kind::diverged, state.t, method.failure()};
    }
    const long n = run_state.step + 1;
    run_state.evaluations = before + system.evaluations();
    // The time is n h, not a sum of h, so that it does not accumulate round-off.
    state.t = start + static_cast<double>(n) * plan.step;
    const std::size_t moving = system.moving();
    if (const std::size_t bad = first_not_finite(state, moving); bad < moving)
      return diverged(system, state, bad, plan.step);
    run_state.step = n;
    if (!seen) continue;
    seen->advance();
    const bool ends = n == steps;
    const bool stops = !ends && stop && stop(*seen);
    for (const Observer& observe : observers)
      observe(*seen, {n, run_state.evaluations, ends || n % every == 0, ends || stops, stops, &state});
    if (stops) return {Outcome::Kind::stopped, state.t, {}};
  }
  return {Outcome::Kind::finished, state.t, {}};
}

}  // namespace

long step_count(const RunPlan& plan) {
  TALUS_DEMAND(plan.step > 0.0 && plan.end > 0.0 && std::isfinite(plan.step) && std::isfinite(plan.end));
  // The fraction of a step absorbs the round-off of end/step when end is meant as a whole number of steps.
  return std::max(1L, static_cast<long>(std::ceil(plan.end / plan.step - 1e-9)));
}

Outcome simulate(RigidBodySystem& system, RunState& run_state, const RunPlan& plan, std::span<const Observer> observers,
                 const StopCondition& stop, Snapshot* seen) {
  return std::visit([&](auto& method) { return run(system, method, run_state, plan, observers, stop, seen); },
                    run_state.integrator);
}

Outcome simulate(RigidBodySystem& system, Integrator& integrator, State& state, const RunPlan& plan,
                 std::span<const Observer> observers, const StopCondition& stop) {
  RunState run_state = initial_run_state(integrator, state);
  run_state.evaluations = system.evaluations();
  const Outcome outcome = simulate(system, run_state, plan, observers, stop);
  state = outcome ? synchronized(run_state, system, plan) : run_state.state;
  integrator = std::move(run_state.integrator);
  return outcome;
}

}  // namespace talus
