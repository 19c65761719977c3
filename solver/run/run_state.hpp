#pragma once

#include "solver/integrate/integrator_list.hpp"
#include "solver/state/state.hpp"

namespace talus {

class Archive;
class RigidBodySystem;
struct RunPlan;

/// A run between two steps: all data that its next step depends on.
struct RunState {
  Integrator integrator;
  State state;         ///< as stored by the integrator, possibly staggered
  double start{};      ///< time of the first state [T]
  long step{};         ///< steps done; 0: not yet started
  long evaluations{};  ///< force evaluations done

  /// Serializes all members except the type of the integrator. Before restoring, integrator and state must belong to
  /// the same scene, at any time.
  void serialize(Archive& archive);
};

/// The run of an integrator before its first step, starting from a state and its time.
[[nodiscard]] RunState initial_run_state(const Integrator& integrator, const State& state);

/// The state of a run with all its parts at state.t and its modes up to date, as observers see it.
[[nodiscard]] State synchronized(const RunState& run_state, RigidBodySystem& system, const RunPlan& plan);

}  // namespace talus
