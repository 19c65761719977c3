#pragma once

#include <functional>
#include <span>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/outcome.hpp"
#include "solver/run/run_plan.hpp"

namespace talus {

/// What an observer is told beside the state.
struct StepInfo {
  long step{};          ///< steps done; 0 for the initial state
  long evaluations{};   ///< force evaluations done
  bool due{};           ///< a record of the history falls on this step (always on the first and the last)
  const State* held{};  ///< the state as the integrator holds it: of a staggered method, velocities at t and
                        ///< coordinates half a step on, as the listings of 1993 print them
};

/// Sees the state, all parts at the same time, after the start and after each step; cannot change the run.
using Observer = std::function<void(const State&, const StepInfo&)>;

/// Ends a run early when it returns true for the state after a step.
using StopCondition = std::function<bool(const State&)>;

/// Steps that a plan takes.
[[nodiscard]] long step_count(const RunPlan& plan);

/// Advances the state from its own time by the plan, in steps of equal length t0 + n h, until plan.end or `stop`.
/// On return the state is synchronised: all its parts are at state.t.
/// The outcome is `diverged` when a coordinate or velocity is no longer finite, with the body and the time.
Outcome simulate(RigidBodySystem& system, Integrator& integrator, State& state, const RunPlan& plan,
                 std::span<const Observer> observers = {}, const StopCondition& stop = {});

}  // namespace talus
