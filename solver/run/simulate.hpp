#pragma once

#include <span>

#include "solver/run/observer.hpp"
#include "solver/run/outcome.hpp"
#include "solver/run/run_plan.hpp"
#include "solver/state/state.hpp"

namespace talus {

class Integrator;
class RigidBodySystem;
struct RunState;

/// Steps that a plan takes.
[[nodiscard]] long step_count(const RunPlan& plan);

/// Takes a run on, from where it stands to the plan's end or until `stop`, in steps of equal length t0 + n h. However
/// often it is stopped and taken on, also by another process, the bits are those of a run that never was: observers
/// see each step once, the first state only at the very start. The plan stays the same throughout.
/// The outcome is `diverged` when a coordinate or velocity is no longer finite, with the body and the time.
/// `seen` is what the observers see, if it is to outlast the run: afterwards it is of the last state that they saw, if
/// they requested it.
Outcome simulate(RigidBodySystem& system, RunState& run_state, const RunPlan& plan,
                 std::span<const Observer> observers = {}, const StopCondition& stop = {}, Snapshot* seen = nullptr);

/// The same from the state's own time. On return the state is synchronised: all its parts are at state.t.
Outcome simulate(RigidBodySystem& system, Integrator& integrator, State& state, const RunPlan& plan,
                 std::span<const Observer> observers = {}, const StopCondition& stop = {});

}  // namespace talus
