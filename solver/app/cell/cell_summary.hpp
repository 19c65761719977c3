#pragma once

#include <string>

#include "solver/io/cell/write_cell.hpp"

namespace talus::app {

/// Summary of a cell's run as text for the terminal.
[[nodiscard]] std::string cell_summary(const CellScene& scene, CellRun& run, const CellOutcome& outcome);

/// Summary of a cell before it is run: discs, law, contact time and step, expected cost and output.
[[nodiscard]] std::string cell_check(const CellScene& scene);

}  // namespace talus::app
