#pragma once

#include "solver/integrate/integrator_list.hpp"
#include "solver/state/state.hpp"

namespace talus {

class Archive;
class RigidBodySystem;
struct RunPlan;

/// A run between two steps: all that its next step depends on.
struct RunState {
  Integrator integrator;
  State state;         ///< as the integrator holds it, which may be staggered
  double start{};      ///< time of the first state [T]
  long step{};         ///< steps done; 0: not yet begun
  long evaluations{};  ///< force evaluations done

  /// Names all parts but the kind of the integrator. Before it is put back, integrator and state are those of the same
  /// scene, at any time.
  void serialize(Archive& archive);
};

/// The run of an integrator from a state and its time, before its first step.
[[nodiscard]] RunState initial_run_state(const Integrator& integrator, const State& state);

/// The state of a run with all its parts at state.t and its modes updated, as observers see it.
[[nodiscard]] State synchronized(const RunState& run_state, RigidBodySystem& system, const RunPlan& plan);

}  // namespace talus
