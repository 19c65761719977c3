#pragma once

#include <span>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/observer.hpp"
#include "solver/run/outcome.hpp"
#include "solver/run/run_plan.hpp"

namespace talus {

/// Steps that a plan takes.
[[nodiscard]] long step_count(const RunPlan& plan);

/// A run between two steps: all that its next step depends on.
struct Standing {
  Integrator integrator;
  State state;         ///< as the integrator holds it, which may be staggered
  double start{};      ///< time of the first state [T]
  long step{};         ///< steps done; 0: not yet begun
  long evaluations{};  ///< force evaluations done

  /// Names all parts but the kind of the integrator. Before it is put back, integrator and state are those of the same
  /// scene, at any time.
  void remember(Memory& memory);
};

/// A run that has not yet begun, from a state and its time.
[[nodiscard]] Standing standing_at_start(const Integrator& integrator, const State& state);

/// The state of a run that stands, all its parts at state.t and its modes settled: what observers see.
[[nodiscard]] State synchronized(const Standing& standing, RigidBodySystem& system, const RunPlan& plan);

/// Takes a run on, from where it stands to the plan's end or until `stop`, in steps of equal length t0 + n h. However
/// often it is stopped and taken on, also by another process, the bits are those of a run that never was: observers
/// see each step once, the first state only at the very start. The plan stays the same throughout.
/// The outcome is `diverged` when a coordinate or velocity is no longer finite, with the body and the time.
/// `seen` is what the observers see, if it is to outlast the run: afterwards it is of the last state that they saw, if
/// they requested it.
Outcome simulate(RigidBodySystem& system, Standing& standing, const RunPlan& plan,
                 std::span<const Observer> observers = {}, const StopCondition& stop = {}, Snapshot* seen = nullptr);

/// The same from the state's own time. On return the state is synchronised: all its parts are at state.t.
Outcome simulate(RigidBodySystem& system, Integrator& integrator, State& state, const RunPlan& plan,
                 std::span<const Observer> observers = {}, const StopCondition& stop = {});

}  // namespace talus
