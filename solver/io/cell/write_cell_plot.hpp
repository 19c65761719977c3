#pragma once

#include <string>

#include "solver/io/cell/write_cell.hpp"

namespace talus {

/// plot.json of a cell: figures over the columns of its history.csv and profile.csv, which `talus plot` draws, and
/// where its states are (read_run_folder).
[[nodiscard]] std::string cell_plot_json(const CellScene& scene, const CellRun& run);

}  // namespace talus
