#pragma once

#include <functional>
#include <vector>

#include "solver/dynamics/dynamics.hpp"

namespace talus {

/// The state of a run after a step, as its observers see it: all parts at the same time, modes up to date, and all
/// derived quantities. Each stage (state, geometry, depths, pulls, loads, forces, energies) is evaluated at its first
/// request, once for all observers; stages that are not requested cost nothing.
class Snapshot {
 public:
  /// Without a state until follow() or set(). The Dynamics must outlive the snapshot.
  explicit Snapshot(const Dynamics& dynamics);
  /// Snapshot of the given state, whose modes must be up to date.
  Snapshot(const Dynamics& dynamics, const State& state);
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

  const Dynamics& dynamics() const { return *dynamics_; }

  /// The state, synchronised. (The integrator may still hold the modes from before its last kick, with which a slack
  /// cable would seem to push.)
  const State& state() const {
    if (!has(Stage::state)) evaluate_state();
    return state_;
  }
  /// Poses and velocities of all bodies, paths of all cables, gaps of the contacts in the neighbourhood.
  const Workspace& geometry() const {
    if (!has(Stage::geometry)) evaluate_geometry();
    return work_;
  }
  /// Largest overlap of each contact [L]; negative while its bodies are apart, which requires a search for some shapes.
  const std::vector<double>& depths() const {
    if (!has(Stage::depths)) evaluate_depths();
    return depths_;
  }
  /// The geometry and the sums of the cable pulls at their joints (JointPoints::force).
  const Workspace& pulls() const {
    if (!has(Stage::pulls)) evaluate_pulls();
    return work_;
  }
  /// The pulls and the contact and cable forces on each body (Workspace::wrenches).
  const Workspace& loads() const {
    if (!has(Stage::loads)) evaluate_loads();
    return work_;
  }
  const LawForces& forces() const {
    if (!has(Stage::forces)) evaluate_forces();
    return forces_;
  }
  const Energies& energies() const {
    if (!has(Stage::energies)) evaluate_energies();
    return energies_;
  }
  const Momenta& momenta() const {
    if (!has(Stage::energies)) evaluate_energies();
    return momenta_;
  }

  /// Replaces the state; its modes must be up to date.
  void set(const State& state);

  /// For the code that steps a run. `synchronise` writes the run's present state, with all parts at the same time, into
  /// a State.
  void follow(std::function<void(State&)> synchronise) { synchronise_ = std::move(synchronise); }
  /// Call after each step of the run: invalidates all stages.
  void advance() { stages_ = 0; }
  /// Call when the run ends: the snapshot keeps the last state that was requested.
  void end();

 private:
  enum class Stage : unsigned {
    state = 1,
    geometry = 2,
    depths = 4,
    pulls = 8,
    loads = 16,
    forces = 32,
    energies = 64
  };

  bool has(Stage stage) const { return (stages_ & static_cast<unsigned>(stage)) != 0; }
  void done(Stage stage) const { stages_ |= static_cast<unsigned>(stage); }
  void evaluate_state() const;
  void evaluate_geometry() const;
  void evaluate_depths() const;
  void evaluate_pulls() const;
  void evaluate_loads() const;
  void evaluate_forces() const;
  void evaluate_energies() const;

  const Dynamics* dynamics_;
  std::function<void(State&)> synchronise_;
  mutable unsigned stages_{};
  mutable State state_;
  mutable Workspace work_;
  mutable std::vector<double> depths_;
  mutable LawForces forces_;
  mutable Energies energies_;
  mutable Momenta momenta_;
  mutable Rates rates_;
};

}  // namespace talus
