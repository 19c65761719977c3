#include "solver/dynamics/rigid_body_system.hpp"

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"

namespace talus {

static_assert(Splittable<RigidBodySystem> && Differentiable<RigidBodySystem>);

RigidBodySystem::RigidBodySystem(const Dynamics& dynamics, bool ledger)
    : dynamics_{&dynamics}, work_{dynamics.workspace()}, rates_{rest_state(dynamics.model())}, ledger_{ledger} {}

void RigidBodySystem::drift(State& state, double h) {
  const std::size_t moving = dynamics_->moving(state, work_);
  if (!dynamics_->follows_motion()) return drift_coordinates(state, h, moving);
  // The memory follows from the geometry at the midpoint: second order and, if it only adds the slip, time-reversible.
  drift_coordinates(state, 0.5 * h, moving);
  dynamics_->update(state, work_);
  dynamics_->drift_memory(state, work_, h);
  drift_coordinates(state, 0.5 * h, moving);
}

void RigidBodySystem::kick(State& state, double h) {
  evaluate(state, rates_);
  kick_velocities(state, rates_, h);
}

void RigidBodySystem::begin(State& state) {
  dynamics_->update(state, work_);
  dynamics_->begin(state, work_);
}

void RigidBodySystem::update_modes(State& state) {
  dynamics_->update(state, work_);
  dynamics_->update_modes(state, work_);
}

void RigidBodySystem::update_modes(State& state, const State& before) {
  dynamics_->update(state, work_);
  dynamics_->update_modes(state, work_, &before);
}

GuardBounds RigidBodySystem::guards(const State& state, bool same, double horizon, std::vector<double>& out) {
  if (!same) dynamics_->update(state, work_);
  const double longest_step = dynamics_->update_far(state, horizon, work_);
  out.resize(state.mode.size());
  const bool none_ends = dynamics_->none_ends(work_, horizon);
  return {!none_ends && dynamics_->guards(state, work_, out, horizon), longest_step};
}

double RigidBodySystem::safe_step(const State& state, double horizon) {
  if (dynamics_->contacts().candidates() == 0) return horizon;
  dynamics_->update(state, work_);
  return dynamics_->safe_step(work_, horizon);
}

void RigidBodySystem::guards_of(const State& state, std::span<const std::size_t> modes, std::span<double> out) {
  dynamics_->guards_of(state, modes, work_, out);
}

void RigidBodySystem::linearization(const State& state, LinearSegment& out) {
  dynamics_->update(state, work_);
  dynamics_->linearization(state, work_, out);
}

void RigidBodySystem::count() {
  if (evaluations_ == allowed_) throw TooManyEvaluations{};
  ++evaluations_;
}

void RigidBodySystem::derivative(const State& state, Rates& out) {
  count();
  dynamics_->update(state, work_);
  dynamics_->rates(state, work_, out, ledger_, true);
}

void RigidBodySystem::evaluate(State& state, Rates& out) {
  count();
  dynamics_->evaluate(state, work_, out, ledger_);
}

}  // namespace talus
