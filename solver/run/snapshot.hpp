#pragma once

#include <functional>
#include <vector>

#include "solver/dynamics/dynamics.hpp"

namespace talus {

/// The state of a run after a step, as its observers see it: all parts at the same time and modes up to date, with all
/// that follows from it. Each stage (state, geometry, depths, pulls, loads, forces, energies) is evaluated when it is first
/// requested, once for all observers; what nobody requests costs nothing.
class Snapshot {
 public:
  /// Of no state yet: see follow(). The Dynamics must outlive it.
  explicit Snapshot(const Dynamics& dynamics);
  /// Of a given state, whose modes are up to date.
  Snapshot(const Dynamics& dynamics, const State& state);
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

  const Dynamics& dynamics() const { return *dynamics_; }

  /// The state, synchronised. (A method may hold its modes as they were before its last kick, with which a slack cable
  /// would seem to push.)
  const State& state() const {
    if (!has(Stage::state)) evaluate_state();
    return state_;
  }
  /// Poses and velocities of all bodies, paths of all cables, gaps of the contacts within reach.
  const Workspace& geometry() const {
    if (!has(Stage::geometry)) evaluate_geometry();
    return work_;
  }
  /// Largest overlap of each contact [L]; negative while its bodies are apart, which for some shapes takes a search.
  const std::vector<double>& depths() const {
    if (!has(Stage::depths)) evaluate_depths();
    return depths_;
  }
  /// The geometry with the sums of the cables' pulls at their joints (JointPoints::force).
  const Workspace& pulls() const {
    if (!has(Stage::pulls)) evaluate_pulls();
    return work_;
  }
  /// And with what contacts and cables exert on each body (Workspace::wrenches).
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

  /// Of another state by hand, whose modes are up to date.
  void set(const State& state);

  /// For who steps a run. `synchronise` writes the run's present state, with all parts at the same time, into a State.
  void follow(std::function<void(State&)> synchronise) { synchronise_ = std::move(synchronise); }
  /// The run has made a step: nothing of it is evaluated yet.
  void advance() { stages_ = 0; }
  /// The run goes no further: the snapshot stays that of the last state that was requested.
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
