#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/base/dimension.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/run/energy_ledger.hpp"
#include "solver/run/extremes.hpp"
#include "solver/run/observer.hpp"
#include "solver/run/snapshot.hpp"

namespace talus {

/// One quantity of a history: its name, e.g. "rock.vx", "top.tension", "energy.kinetic", and its dimension.
struct Column {
  std::string name;
  Dimension dimension;
};

/// The columns of a history of this model; with `ledger`, including those of the energy and momentum balance.
[[nodiscard]] std::vector<Column> history_columns(const Model& model, bool ledger);

/// Quantities of a run over time, row by row, in the scene's consistent units. The first column is "time".
struct History {
  std::vector<Column> columns;
  std::vector<std::vector<double>> rows;
  bool row_of_stop{false};  ///< the last row was added only because the run stopped

  /// Call before adding a step: removes the row that was added only because the run stopped.
  void proceed();
  /// Adds the row of a step where output is due or where the run stops.
  void add(std::vector<double> row, bool due);

  /// Serializes the rows; the columns follow from the scene.
  void serialize(Archive& archive);
};

/// Observer that fills a history and collects extremes over every step. Columns: for each moving body x, y, vx, vy and,
/// if it rotates, angle and spin; for each contact overlap and force; for each cable elongation and tension; with a
/// ledger energies, losses and balance errors.
class Recorder {
 public:
  /// `start` is the run's first state. Without `ledger`, no balances are computed and their columns are omitted. The
  /// Dynamics must outlive the recorder.
  Recorder(const Dynamics& dynamics, const State& start, bool ledger = true);

  /// Adds a row if output is due, and one for the step at which the run stops; that row is removed when the run is
  /// resumed. The ledger and the extremes are updated at every step.
  void operator()(const Snapshot& snapshot, const StepInfo& info);

  /// Serializes the data carried from step to step; restore into a recorder with the same start.
  void serialize(Archive& archive);

  const History& history() const { return history_; }
  /// All columns at the last observed step.
  const std::vector<double>& row() const { return row_; }
  /// Empty when the ledger is off.
  const std::optional<EnergyLedger>& ledger() const { return ledger_; }
  /// The balance at the last observed step; all zero when the ledger is off.
  const Accounts& accounts() const { return accounts_; }

  /// Extremes of each column over all steps.
  const Extremes& extremes() const { return extremes_; }

 private:
  void fill_row(const Snapshot& snapshot);

  /// A body with columns in the history.
  struct Moving {
    std::size_t body{};
    bool turns{};
    std::size_t angle{};  ///< index of its angle among the coordinates
  };

  const Dynamics* dynamics_;
  std::optional<EnergyLedger> ledger_;
  Accounts accounts_;
  History history_;
  std::vector<Moving> moving_;
  std::vector<double> row_;
  Extremes extremes_;
};

}  // namespace talus
