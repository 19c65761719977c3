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

/// Numbers of the columns of a history that a recorder records at every step, in ascending order; an empty list: none;
/// without a list: all.
using RecordedColumns = std::optional<std::vector<std::size_t>>;

/// Observer that fills a history and collects extremes over every step. Columns: for each moving body x, y, vx, vy and,
/// if it rotates, angle and spin; for each contact overlap and force; for each cable elongation and tension; with a
/// ledger energies, losses and balance errors.
class Recorder {
 public:
  /// `start` is the run's first state. Without `ledger`, no balances are computed and their columns are omitted.
  /// `recorded`: the columns with extremes; the others are evaluated only at steps that have a row of the history. The
  /// Dynamics must outlive the recorder.
  Recorder(const Dynamics& dynamics, const State& start, bool ledger = true, RecordedColumns recorded = {});

  /// Adds a row if output is due, and one for the step at which the run stops; that row is removed when the run is
  /// resumed. The ledger and the extremes are updated at every step.
  void operator()(const Snapshot& snapshot, const StepInfo& info);

  /// Serializes the data carried from step to step; restore into a recorder with the same start.
  void serialize(Archive& archive);

  const History& history() const { return history_; }
  /// Whether all columns are recorded.
  bool records_all() const { return !recorded_; }
  /// All columns. The time, the recorded columns and those of the ledger belong to the last observed step; others are
  /// older, unless this step has a row of the history.
  const std::vector<double>& row() const { return row_; }
  /// Empty when the ledger is off.
  const std::optional<EnergyLedger>& ledger() const { return ledger_; }
  /// The balance at the last observed step; all zero when the ledger is off.
  const Accounts& accounts() const { return accounts_; }

  /// Extremes of a recorded column over all steps.
  [[nodiscard]] Extreme extreme(std::size_t column) const;

 private:
  /// Groups of columns that are evaluated together. Those of the ledger are known at every step.
  struct ColumnGroups {
    bool bodies{true}, contacts{true}, cables{true};
    bool all_bodies{true};  ///< also those without a recorded column
  };

  ColumnGroups groups_of(const std::vector<std::size_t>& columns) const;
  void fill_row(const Snapshot& snapshot, const ColumnGroups& groups);

  /// A body with columns in the history.
  struct Moving {
    std::size_t body{};
    bool turns{};
    std::size_t angle{};   ///< index of its angle among the coordinates
    std::size_t column{};  ///< its first
    bool recorded{};       ///< has a recorded column
  };

  const Dynamics* dynamics_;
  std::optional<EnergyLedger> ledger_;
  Accounts accounts_;
  History history_;
  std::vector<Moving> moving_;
  std::size_t first_of_contacts_{}, first_of_cables_{}, first_of_accounts_{};  ///< columns; that of the time is 0
  RecordedColumns recorded_;
  ColumnGroups recorded_groups_;  ///< those with a recorded column
  std::vector<double> row_;
  std::vector<double> recorded_row_;  ///< the recorded columns of `row_`
  Extremes extremes_;                 ///< of the recorded columns
};

}  // namespace talus
