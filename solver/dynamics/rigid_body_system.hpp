#pragma once

#include <exception>
#include <limits>
#include <span>

#include "solver/dynamics/dynamics.hpp"
#include "solver/integrate/guard_bounds.hpp"

namespace talus {

/// Thrown by an evaluation beyond the number that a RigidBodySystem is allowed.
class TooManyEvaluations : public std::exception {
 public:
  const char* what() const noexcept override { return "more force evaluations than allowed"; }
};

/// A Dynamics with its workspace: the system that integrators advance. Models both Splittable and Differentiable, and
/// counts its force evaluations.
class RigidBodySystem {
 public:
  /// `ledger` off leaves work and impulse of the states untouched. The Dynamics must outlive the system.
  explicit RigidBodySystem(const Dynamics& dynamics, bool ledger = true);

  void drift(State& state, double h);
  void kick(State& state, double h);
  /// Initialises the modes of the first state of a run; later states require update_modes() alone.
  void begin(State& state);
  void update_modes(State& state);
  /// At the end of a step of derivative(), from the state at its beginning; see Dynamics::update_modes().
  void update_modes(State& state, const State& before);
  void derivative(const State& state, Rates& out);
  void evaluate(State& state, Rates& out);

  /// Computes the guards in the state's modes. `same`: the state is that of the last update_modes() or derivative().
  /// Guards of bodies that do not touch in the time `horizon` [T] at their present speed are infinite; see GuardBounds.
  /// No force evaluation.
  GuardBounds guards(const State& state, bool same, double horizon, std::vector<double>& out);
  /// Computes the guards of a few modes, at any state; other elements of `out` may change, too.
  void guards_of(const State& state, std::span<const std::size_t> modes, std::span<double> out);
  /// Longest step [T], at most `horizon`, in which no two bodies can pass each other without a contact in the state at
  /// its end, at their present speed and under gravity. No force evaluation.
  double safe_step(const State& state, double horizon);
  bool follows(const State& state) const { return dynamics_->follows(state); }
  std::vector<double> lengths() const { return dynamics_->lengths(); }
  /// Linear equations of motion of the state whose derivative() was evaluated last.
  void linear_segment(const State& state, LinearSegment& out) const { dynamics_->linear_segment(state, work_, out); }
  /// See Dynamics::linearization(); at any state.
  void linearization(const State& state, LinearSegment& out);
  bool keeps_accounts() const { return ledger_; }
  bool moves_memory() const { return dynamics_->follows_motion(); }
  void wake_all(State& state) const { dynamics_->wake_all(state); }
  /// Number of coordinates up to the last of an awake body, in the state evaluated last.
  std::size_t moving() const { return work_.active.moving; }

  const Dynamics& dynamics() const { return *dynamics_; }
  /// Force evaluations so far: one for each kick, derivative or evaluate.
  long evaluations() const { return evaluations_; }
  /// Sets the number of evaluations allowed in all: the next one throws TooManyEvaluations, also within a step. (Step
  /// control that cannot meet its tolerance would otherwise continue with ever shorter steps.)
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
