#pragma once

#include <string>

#include "solver/io/cell_record.hpp"

namespace talus::app {

/// What a run of a cell gave, for the terminal.
[[nodiscard]] std::string cell_summary(const CellScene& scene, CellRun& run, const CellOutcome& outcome);

}  // namespace talus::app
