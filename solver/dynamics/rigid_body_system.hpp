#pragma once

#include <exception>
#include <limits>
#include <span>

#include "solver/dynamics/dynamics.hpp"
#include "solver/integrate/guard_bounds.hpp"

namespace talus {

/// Thrown by an evaluation that a RigidBodySystem was not allowed any more.
class TooManyEvaluations : public std::exception {
 public:
  const char* what() const noexcept override { return "more force evaluations than allowed"; }
};

/// A Dynamics with its scratch: the system that integrators advance. Models both Splittable and Differentiable, and
/// counts its force evaluations.
class RigidBodySystem {
 public:
  /// `ledger` off leaves work and impulse of the states untouched. The Dynamics must outlive the system.
  explicit RigidBodySystem(const Dynamics& dynamics, bool ledger = true);

  void drift(State& state, double h);
  void kick(State& state, double h);
  /// Modes of a run's first state; after it update_modes() alone.
  void begin(State& state);
  void update_modes(State& state);
  /// At the end of a step of derivative(), from the state at its beginning: see Dynamics.
  void update_modes(State& state, const State& before);
  void derivative(const State& state, Rates& out);
  void evaluate(State& state, Rates& out);

  /// Guards in the state's modes; `same`: of the state that was settled, or whose derivative was asked for, last. Of
  /// bodies that at their speed do not touch in the time ahead [T] they are infinite; see GuardBounds. No force
  /// evaluation.
  GuardBounds guards(const State& state, bool same, double ahead, std::vector<double>& out);
  /// Those of a few modes, at any state; the numbers of others may change, too.
  void guards_of(const State& state, std::span<const std::size_t> modes, std::span<double> out);
  bool follows(const State& state) const { return dynamics_->follows(state); }
  std::vector<double> lengths() const { return dynamics_->lengths(); }
  /// The linear piece of the state whose derivative was the last.
  void affine_piece(const State& state, AffinePiece& out) const { dynamics_->affine_piece(state, work_, out); }
  /// See Dynamics; at any state.
  void linearization(const State& state, AffinePiece& out);
  bool keeps_accounts() const { return ledger_; }
  bool moves_memory() const { return dynamics_->follows_motion(); }
  void wake_all(State& state) const { dynamics_->wake_all(state); }
  /// Coordinates behind the first so many were of bodies that slept in the last state that was looked at.
  std::size_t moving() const { return work_.active.moving; }

  const Dynamics& dynamics() const { return *dynamics_; }
  /// Force evaluations so far: one for each kick, derivative or evaluate.
  long evaluations() const { return evaluations_; }
  /// Allows so many in all: the next throws TooManyEvaluations, also from within a step. (Step control whose tolerance
  /// cannot be kept would else go on in ever shorter steps.)
  void allow(long evaluations) { allowed_ = evaluations; }

 private:
  void count();

  const Dynamics* dynamics_;
  Workspace work_;
  Rates rates_;
  bool ledger_;
  long evaluations_{0};
  long allowed_{std::numeric_limits<long>::max()};
};

}  // namespace talus
