#pragma once

#include <string>

#include "solver/io/cell/write_cell.hpp"

namespace talus {

/// plot.json of a cell: the figures that `talus plot` draws from the columns of history.csv and profile.csv, and the
/// location of the states (see read_run_folder).
[[nodiscard]] std::string cell_plot_json(const CellScene& scene, const CellRun& run);

}  // namespace talus
