#pragma once

#include <memory>

#include "solver/base/archive.hpp"
#include "solver/run/snapshot.hpp"

namespace talus {

/// The accounts of a run at one time: what there is, what was lost, and by how much the sums fail to close.
struct Accounts {
  Energies energies;                           ///< [F L]
  std::array<double, mechanism_count> lost{};  ///< dissipated since the start, by Mechanism [F L]
  Momenta momenta;
  double energy_closure{};            ///< energy + lost - energy at the start [F L]; 0 if the integration were exact
  Vec2 momentum_closure;              ///< momentum - impulse from outside - momentum at the start [M L/T]
  double angular_momentum_closure{};  ///< the same for moments about the world's origin [M L^2/T]

  double dissipated() const;  ///< sum of `lost` [F L]

  /// Names all parts.
  void serialize(Archive& archive);
};

/// Keeps the accounts of energy and momentum of a run against its first state.
class EnergyLedger {
 public:
  /// `start` is the state that everything later is compared with; its modes are settled. The Dynamics must outlive the
  /// ledger.
  EnergyLedger(const Dynamics& dynamics, const State& start);

  [[nodiscard]] Accounts accounts(const Snapshot& snapshot);
  /// The same of a state alone, which is evaluated for it.
  [[nodiscard]] Accounts accounts(const State& state);

  /// Energies of the first state.
  const Energies& start() const { return start_energies_; }

  /// Largest |energy_closure| of the accounts drawn so far [F L].
  double largest_energy_closure() const { return largest_energy_closure_; }
  /// What closures are measured against: the largest kinetic energy seen, or change of energy in one place, whichever
  /// is more.
  double energy_scale() const { return energy_scale_; }

  /// Names what the ledger carries from one step to the next; a ledger of the same start goes on from it.
  void serialize(Archive& archive);

 private:
  const Dynamics* dynamics_;
  std::unique_ptr<Snapshot> own_;  ///< for states without a snapshot; made for the first
  std::array<double, mechanism_count> start_work_{};
  Impulse<double> start_impulse_{};
  Energies start_energies_;
  Momenta start_momenta_;
  double largest_energy_closure_{};
  double energy_scale_{};
};

}  // namespace talus
