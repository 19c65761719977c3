#pragma once

#include <string>

#include "solver/io/cell/write_cell.hpp"

namespace talus::app {

/// What a run of a cell gave, for the terminal.
[[nodiscard]] std::string cell_summary(const CellScene& scene, CellRun& run, const CellOutcome& outcome);

/// What a cell carries and what its step is worth, before it is run.
[[nodiscard]] std::string cell_check(const CellScene& scene);

}  // namespace talus::app
