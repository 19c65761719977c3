#pragma once

#include <string>
#include <vector>

#include "solver/cell/cell_run.hpp"
#include "solver/io/cell/read_cell.hpp"

namespace talus {

/// A number that a run of a cell gives, by its name in files.
struct CellNumber {
  std::string name;
  Dimension dimension;
  Estimate estimate;  ///< error 0 where it has none
  double drift{};     ///< of later over earlier, in standard errors; 0 where it has none
  std::string meaning;
};

/// Dimensionless groups of a cell run so: e, what the steps make of it (law of 1989), friction, contact time over step,
/// stiffness over pressure (K1/(P D)), inertial number, contact time times shear rate, block over disc mass, columns
/// over wall discs; by the mean depth, or that of now in the start-up.
[[nodiscard]] std::vector<CellNumber> cell_groups(const CellScene& scene, CellRun& run);

/// Means of a run after its start-up with errors, then its extremes. In the start-up means are zero.
[[nodiscard]] std::vector<CellNumber> cell_results(const CellRun& run);

/// The head of a column of its CSV files: "top_shear [Pa]", or the bare name without units.
[[nodiscard]] std::string cell_header(const CellScene& scene, std::string_view name, Dimension dimension);

/// What was measured in each LOOP, a line each; headers have units where the scene has.
[[nodiscard]] std::string cell_history_csv(const CellScene& scene, const CellRun& run);

/// The layers of the profile up to the highest in which a disc was; none in the start-up.
[[nodiscard]] std::vector<CellProfile::Layer> filled_layers(const CellRun& run);
/// Their velocity, temperature and solid fraction over the height.
[[nodiscard]] std::string cell_profile_csv(const CellScene& scene, const CellRun& run);

/// How the run came out.
struct CellOutcome {
  bool finished{};
  std::string words;  ///< why not; empty for a run that was stopped
  std::vector<std::string> warnings;
};

/// summary.json: title, units, outcome, parameters, groups, results, ledger, counts. With `resume`, the command that
/// resumes the run, that too.
[[nodiscard]] std::string cell_summary_json(const CellScene& scene, CellRun& run, const CellOutcome& outcome,
                                            const std::string& resume = {});

/// One state for ParaView: VTK XML poly data with a point for each disc (`id`, `radius`, `velocity`, `wall`, with
/// friction `spin`) and a line between the centres of each pair that pushes (`force` [F], `multiple` 1 if one of its
/// free discs has another; the end at the image of a disc has the negative of its `id`).
[[nodiscard]] std::string cell_state_vtp(CellRun& run);

}  // namespace talus
