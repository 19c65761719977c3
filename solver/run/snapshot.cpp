#include "solver/run/snapshot.hpp"

#include "solver/base/error.hpp"

namespace talus {

Snapshot::Snapshot(const Dynamics& dynamics)
    : dynamics_{&dynamics},
      state_{rest_state(dynamics.model())},
      work_{dynamics.workspace()},
      depths_(dynamics.contacts().candidates()),
      rates_{state_} {}

Snapshot::Snapshot(const Dynamics& dynamics, const State& state) : Snapshot{dynamics} { set(state); }

void Snapshot::set(const State& state) {
  state_ = state;
  work_.evaluated = Evaluated::nothing;
  stages_ = static_cast<unsigned>(Stage::state);
}

void Snapshot::end() {
  synchronise_ = nullptr;
  done(Stage::state);
}

void Snapshot::evaluate_state() const {
  TALUS_DEMAND(synchronise_ != nullptr);
  synchronise_(state_);
  dynamics_->update_everywhere(state_, work_);
  // Parts that break or wake are evaluated again at once, but without the sleeping parts next to them.
  if (dynamics_->update_modes(state_, work_)) work_.evaluated = Evaluated::nothing;
  done(Stage::state);
}

void Snapshot::evaluate_geometry() const {
  const State& now = state();
  if (work_.evaluated == Evaluated::nothing) dynamics_->update_everywhere(now, work_);
  done(Stage::geometry);
}

void Snapshot::evaluate_depths() const {
  dynamics_->contacts().largest_depths(geometry(), depths_);
  done(Stage::depths);
}

void Snapshot::evaluate_pulls() const {
  static_cast<void>(geometry());
  // For chains on their linear branch the pulls are already computed.
  if (!work_.active.on_linear_branch) dynamics_->cables().load(state_, work_, nullptr);
  done(Stage::pulls);
}

void Snapshot::evaluate_loads() const {
  static_cast<void>(geometry());
  dynamics_->rates(state_, work_, rates_, false);
  done(Stage::loads), done(Stage::pulls);
}

void Snapshot::evaluate_forces() const {
  static_cast<void>(geometry());
  dynamics_->forces(state_, work_, forces_);
  done(Stage::forces);
}

void Snapshot::evaluate_energies() const {
  static_cast<void>(geometry());
  energies_ = dynamics_->energies(state_, work_);
  momenta_ = dynamics_->momenta(work_);
  done(Stage::energies);
}

}  // namespace talus
