#pragma once

#include <string>
#include <vector>

#include "solver/io/cell/write_cell.hpp"

namespace talus::app {

/// Summary of a cell's run as text for the terminal.
[[nodiscard]] std::string cell_summary(const CellScene& scene, CellRun& run, const CellOutcome& outcome);

/// Warnings of a run: discs that did not behave as hard ones, or work that is unaccounted for. The latter is checked in
/// runs that are not historical and have not failed, once the work exceeds the present energy: before, momentary values
/// dominate the ratio.
[[nodiscard]] std::vector<std::string> cell_warnings(const CellScene& scene, CellRun& run);

/// Summary of a cell before it is run: discs, law, contact time and step, expected cost and output.
[[nodiscard]] std::string cell_check(const CellScene& scene);

}  // namespace talus::app
