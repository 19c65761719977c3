#pragma once

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/advance.hpp"

namespace talus::verification::problems {

/// The solver's system with one fault: the slip of a step is computed in the configuration at its end instead of its
/// midpoint. Half-step velocities are thus combined with directions of the full step, as velocity Verlet does in
/// several codes (Vyas et al. 2025).
class LateSlipSystem {
 public:
  explicit LateSlipSystem(const Dynamics& dynamics)
      : dynamics_{&dynamics}, system_{dynamics, false}, work_{dynamics.workspace()} {}

  void drift(State& state, double h) {
    drift_coordinates(state, h);
    dynamics_->update(state, work_);
    Rates rates{state};
    dynamics_->memory_rates(state, work_, rates);
    for (std::size_t i = 0; i < state.z.size(); ++i)
      state.z[i] += h * rates.z[i];
  }
  void kick(State& state, double h) { system_.kick(state, h); }
  void begin(State& state) { system_.begin(state); }
  void update_modes(State& state) { system_.update_modes(state); }
  void update_modes(State& state, const State& before) { system_.update_modes(state, before); }
  void derivative(const State& state, Rates& out) { system_.derivative(state, out); }
  void evaluate(State& state, Rates& out) { system_.evaluate(state, out); }
  long evaluations() const { return system_.evaluations(); }

 private:
  const Dynamics* dynamics_;
  RigidBodySystem system_;
  Workspace work_;
};

}  // namespace talus::verification::problems
