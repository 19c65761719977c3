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

/// The columns of a history of this model; with `ledger` those of the accounts too.
[[nodiscard]] std::vector<Column> history_columns(const Model& model, bool ledger);

/// Quantities of a run over time, row by row, in the scene's consistent units. The first column is "time".
struct History {
  std::vector<Column> columns;
  std::vector<std::vector<double>> rows;
  bool row_of_stop{false};  ///< the last row is there only because the run stopped

  /// Before what a step adds: a row of a stop gives way, now that the run was taken on.
  void proceed();
  /// Adds the row of a step at which one is due, or with which the run stops.
  void add(std::vector<double> row, bool due);

  /// Names the rows; the columns are the scene's.
  void serialize(Archive& archive);
};

/// Fills a history and keeps the extreme values of every step: for each body that moves x, y, vx, vy and, if it turns,
/// angle and spin; for each contact depth and force; for each cable elongation and tension; with a ledger energies,
/// losses and closures.
class Recorder {
 public:
  /// `start` is the run's first state. `ledger` off draws no accounts and leaves their columns out. The Dynamics must
  /// outlive the recorder.
  Recorder(const Dynamics& dynamics, const State& start, bool ledger = true);

  /// Writes a row when one is due, and one for a step with which the run stops, which gives way when it is taken on.
  /// The ledger and the extremes are brought up to date with every step.
  void operator()(const Snapshot& snapshot, const StepInfo& info);

  /// Names what the recorder carries from one step to the next; a recorder of the same start goes on from it.
  void serialize(Archive& archive);

  const History& history() const { return history_; }
  /// All columns at the last step seen.
  const std::vector<double>& row() const { return row_; }
  /// Empty when the ledger is off.
  const std::optional<EnergyLedger>& ledger() const { return ledger_; }
  /// The accounts at the last step seen; all zero when the ledger is off.
  const Accounts& accounts() const { return accounts_; }

  /// Of each column over all steps.
  const Extremes& extremes() const { return extremes_; }

 private:
  void fill_row(const Snapshot& snapshot);

  /// A body with columns.
  struct Moving {
    std::size_t body{};
    bool turns{};
    std::size_t angle{};  ///< its coordinate
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
