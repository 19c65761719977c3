#include "solver/run/energy_ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace talus {

double Accounts::total_dissipated() const { return std::accumulate(dissipated.begin(), dissipated.end(), 0.0); }

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
    now.dissipated[i] = state.work[i] - start_work_[i];
  // Sum of changes, not change of the sum: a potential with a large offset must not swallow the digits of the others.
  const Energies& first = start_energies_;
  const double kinetic = now.energies.kinetic - first.kinetic;
  const double gravity = now.energies.gravity - first.gravity;
  const double applied = now.energies.applied - first.applied;
  const double contacts = now.energies.contacts - first.contacts;
  const double cables = now.energies.cables - first.cables;
  now.energy_balance_error = kinetic + gravity + applied + contacts + cables + now.total_dissipated();
  const Vec2 impulse{state.impulse[0] - start_impulse_[0], state.impulse[1] - start_impulse_[1]};
  now.momentum_balance_error = now.momenta.linear - start_momenta_.linear - impulse;
  now.angular_momentum_balance_error =
      now.momenta.angular - start_momenta_.angular - (state.impulse[2] - start_impulse_[2]);
  keep_larger(largest_energy_balance_error_, std::abs(now.energy_balance_error));
  energy_scale_ = std::max({energy_scale_, now.energies.kinetic, std::abs(gravity), std::abs(applied),
                            std::abs(contacts), std::abs(cables)});
  return now;
}

std::string balance_text(double ratio) {
  return std::isfinite(ratio)
             ? fmt::format("the energy balance is off by {:.3g} % of the largest energy", 100.0 * ratio)
             : "the energies are too large for numbers of the machine, and have no balance";
}

void Accounts::serialize(Archive& archive) {
  archive.number("kinetic", energies.kinetic);
  archive.number("gravity", energies.gravity);
  archive.number("applied", energies.applied);
  archive.number("contacts", energies.contacts);
  archive.number("cables", energies.cables);
  archive.numbers("dissipated", dissipated);
  archive.vector("momentum", momenta.linear);
  archive.number("angular_momentum", momenta.angular);
  archive.number("energy_balance_error", energy_balance_error);
  archive.vector("momentum_balance_error", momentum_balance_error);
  archive.number("angular_momentum_balance_error", angular_momentum_balance_error);
}

void EnergyLedger::serialize(Archive& archive) {
  archive.number("largest_energy_balance_error", largest_energy_balance_error_);
  archive.number("energy_scale", energy_scale_);
}

}  // namespace talus
