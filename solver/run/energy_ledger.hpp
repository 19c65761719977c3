#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "solver/base/archive.hpp"
#include "solver/run/snapshot.hpp"

namespace talus {

/// Keeps the larger of both in `largest`; returns whether that is the value. NaN counts as the largest, and stays.
inline bool keep_larger(double& largest, double value) {
  if (value <= largest || std::isnan(largest)) return false;
  largest = value;
  return true;
}

/// "the energy balance is off by 2 % of the largest energy", for this ratio of both. Energies that exceed the numbers
/// of the machine have none.
[[nodiscard]] std::string balance_text(double ratio);

/// Energy and momentum balance of a run at one time: the stored amounts, the losses and the balance errors.
struct Accounts {
  Energies energies;                                 ///< [F L]
  std::array<double, mechanism_count> dissipated{};  ///< since the start, by Mechanism [F L]
  Momenta momenta;
  double energy_balance_error{};  ///< balance error: energy + dissipated - energy at the start [F L]; zero for an exact
                                  ///< integration
  Vec2 momentum_balance_error;    ///< momentum - external impulse - momentum at the start [M L/T]
  double angular_momentum_balance_error{};  ///< the same for moments about the world origin [M L^2/T]

  double total_dissipated() const;  ///< sum over all mechanisms [F L]

  /// Serializes all members.
  void serialize(Archive& archive);
};

/// Computes the energy and momentum balances of a run relative to its first state.
class EnergyLedger {
 public:
  /// `start` is the reference state; its modes must be up to date. The Dynamics must outlive the ledger.
  EnergyLedger(const Dynamics& dynamics, const State& start);

  [[nodiscard]] Accounts accounts(const Snapshot& snapshot);
  /// The balance at a state without a snapshot; the ledger evaluates the state itself.
  [[nodiscard]] Accounts accounts(const State& state);

  /// Energies of the first state [F L].
  const Energies& start() const { return start_energies_; }

  /// Largest |energy_balance_error| of all balances computed so far [F L]; NaN if one of them is.
  double largest_energy_balance_error() const { return largest_energy_balance_error_; }
  /// Reference energy for balance errors [F L]: the largest kinetic energy so far or, if larger, the largest change of
  /// any single other form of energy.
  double energy_scale() const { return energy_scale_; }

  /// Serializes the data that the ledger carries from step to step; restore into a ledger with the same start.
  void serialize(Archive& archive);

 private:
  const Dynamics* dynamics_;
  std::unique_ptr<Snapshot> own_;  ///< for states without a snapshot; created at first use
  std::array<double, mechanism_count> start_work_{};
  Impulse<double> start_impulse_{};
  Energies start_energies_;
  Momenta start_momenta_;
  double largest_energy_balance_error_{};
  double energy_scale_{};
};

}  // namespace talus
