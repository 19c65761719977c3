#include "solver/run/energy_ledger.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace talus {

double Accounts::dissipated() const { return std::accumulate(lost.begin(), lost.end(), 0.0); }

EnergyLedger::EnergyLedger(const Dynamics& dynamics, const State& start)
    : dynamics_{&dynamics}, start_work_{start.work}, start_impulse_{start.impulse} {
  const Snapshot first{dynamics, start};
  start_energies_ = first.energies();
  start_momenta_ = first.momenta();
  energy_scale_ = start_energies_.kinetic;
}

Accounts EnergyLedger::accounts(const State& state) {
  if (!own_) own_ = std::make_unique<Snapshot>(*dynamics_);
  own_->set(state);
  return accounts(*own_);
}

Accounts EnergyLedger::accounts(const Snapshot& snapshot) {
  const State& state = snapshot.state();
  Accounts now;
  now.energies = snapshot.energies();
  now.momenta = snapshot.momenta();
  for (std::size_t i = 0; i < mechanism_count; ++i)
    now.lost[i] = state.work[i] - start_work_[i];
  // Sum of changes, not change of the sum: a potential with a large offset must not swallow the digits of the others.
  const Energies& first = start_energies_;
  const double kinetic = now.energies.kinetic - first.kinetic;
  const double gravity = now.energies.gravity - first.gravity;
  const double applied = now.energies.applied - first.applied;
  const double contacts = now.energies.contacts - first.contacts;
  const double cables = now.energies.cables - first.cables;
  now.energy_closure = kinetic + gravity + applied + contacts + cables + now.dissipated();
  const Vec2 impulse{state.impulse[0] - start_impulse_[0], state.impulse[1] - start_impulse_[1]};
  now.momentum_closure = now.momenta.linear - start_momenta_.linear - impulse;
  now.angular_momentum_closure = now.momenta.angular - start_momenta_.angular - (state.impulse[2] - start_impulse_[2]);
  largest_energy_closure_ = std::max(largest_energy_closure_, std::abs(now.energy_closure));
  energy_scale_ = std::max({energy_scale_, now.energies.kinetic, std::abs(gravity), std::abs(applied),
                            std::abs(contacts), std::abs(cables)});
  return now;
}

void Accounts::serialize(Archive& archive) {
  archive.number("kinetic", energies.kinetic);
  archive.number("gravity", energies.gravity);
  archive.number("applied", energies.applied);
  archive.number("contacts", energies.contacts);
  archive.number("cables", energies.cables);
  archive.numbers("lost", lost);
  archive.vector("momentum", momenta.linear);
  archive.number("angular_momentum", momenta.angular);
  archive.number("energy_closure", energy_closure);
  archive.vector("momentum_closure", momentum_closure);
  archive.number("angular_momentum_closure", angular_momentum_closure);
}

void EnergyLedger::serialize(Archive& archive) {
  archive.number("largest_energy_closure", largest_energy_closure_);
  archive.number("energy_scale", energy_scale_);
}

}  // namespace talus
