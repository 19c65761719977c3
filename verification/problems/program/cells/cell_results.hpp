#pragma once

#include "verification/check/case.hpp"
#include "verification/problems/program/cells/reference_cell.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/program/program_run.hpp"

/// summary.json of the cell of the case `cell_files` beside the second program: results with their errors, parameters,
/// energies and dimensionless groups.
namespace talus::verification::problems::cell_files {

/// Adds the checks. `before`: the state at the start; `ended`: what the program printed.
void check_summary(const records::Node& summary, const Expected& expected, const VirtualDiscs& before,
                   const ProgramEnd& ended, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::cell_files
