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

/// Number of steps in a plan.
[[nodiscard]] long step_count(const RunPlan& plan);

/// Continues a run from its present state to the end of the plan or until `stop`, with equal steps: step n ends at
/// t0 + n h. Results are bit-identical to an uninterrupted run, however often the run is interrupted and resumed, also
/// by another process: observers see each step once, and the first state only at the very start. The plan must not
/// change. The outcome is `diverged`, with the body and the time, when a coordinate or velocity is no longer finite.
/// `seen` is the snapshot for the observers, if it is to outlast the run: afterwards it refers to the last state that
/// the observers requested.
Outcome simulate(RigidBodySystem& system, RunState& run_state, const RunPlan& plan,
                 std::span<const Observer> observers = {}, const StopCondition& stop = {}, Snapshot* seen = nullptr);

/// As above, from the state's time. On return the state is synchronised: all its parts are at state.t.
Outcome simulate(RigidBodySystem& system, Integrator& integrator, State& state, const RunPlan& plan,
                 std::span<const Observer> observers = {}, const StopCondition& stop = {});

}  // namespace talus
