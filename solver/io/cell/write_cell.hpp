#pragma once

#include <string>
#include <vector>

#include "solver/cell/cell_run.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/run/outcome.hpp"

namespace talus {

/// A numerical result of a cell run, with its name in files.
struct CellNumber {
  std::string name;
  Dimension dimension;
  Estimate estimate;  ///< error 0 if it has none
  double drift{};     ///< later mean minus earlier mean, in standard errors; 0 if there is none
  std::string meaning;
};

/// Dimensionless groups of a cell run: restitution e, e as the steps realize it (law of 1989), friction, contact time
/// over step, stiffness over pressure (K1/(P D)), inertial number, contact time times shear rate, block over disc mass,
/// columns over wall discs. They use the mean depth, or during the start-up the current one.
[[nodiscard]] std::vector<CellNumber> cell_groups(const CellScene& scene, CellRun& run);

/// Means of a run after its start-up, with errors, then its extremes. During the start-up the means are zero.
[[nodiscard]] std::vector<CellNumber> cell_results(const CellRun& run);

/// Header of a column of a cell's CSV files: "top_shear [Pa]", or the bare name if the scene has no units.
[[nodiscard]] std::string cell_header(const CellScene& scene, std::string_view name, Dimension dimension);

/// Numbers of a cell's run, row by row.
struct CellTable {
  struct Column {
    std::string name;
    Dimension dimension{};
  };
  std::vector<Column> columns;
  std::vector<double> numbers;

  std::size_t rows() const { return columns.empty() ? 0 : numbers.size() / columns.size(); }
};
/// The means over each LOOP, a row each.
[[nodiscard]] CellTable cell_history(const CellScene& scene, const CellRun& run);
/// Velocity, temperature, solid fraction and, with friction, spin of the layers in which discs were, with their errors;
/// no row during the start-up.
[[nodiscard]] CellTable cell_profile(const CellScene& scene, const CellRun& run);
/// history.csv and profile.csv: these tables; headers have units if the scene has.
[[nodiscard]] std::string cell_csv(const CellScene& scene, const CellTable& table);

/// Outcome of a cell run, with its warnings.
struct CellOutcome {
  Outcome outcome;
  std::vector<std::string> warnings;
};

/// summary.json: title, units, outcome, parameters, groups, results, ledger, counts, and `resume`, the command that
/// resumes the run, unless it is empty.
[[nodiscard]] std::string cell_summary_json(const CellScene& scene, CellRun& run, const CellOutcome& outcome,
                                            const std::string& resume = {});

/// One state for ParaView: VTK XML poly data with a point for each disc (`id`, `radius`, `velocity`, `wall`, with
/// friction `spin`) and a line between the centres of each pair in contact (`force` [F]; `multiple`, 1 if one of its
/// free discs has another contact). A line that ends at the periodic image of a disc ends at an extra point, whose `id`
/// is the negative of the disc's.
[[nodiscard]] std::string cell_state_vtp(CellRun& run);

}  // namespace talus
