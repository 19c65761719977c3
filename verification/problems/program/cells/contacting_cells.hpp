#pragma once

#include "verification/check/case.hpp"
#include "verification/study/program/program_run.hpp"

/// Cells whose discs touch: the fields of contact laws, from positions and velocities in the states of cell.pvd; part
/// of the case `cell_files`.
namespace talus::verification::problems::cell_files {

/// Runs a cell of latching springs with growth and friction and one of dashpots that pull, with a state for each step,
/// and adds the checks of their forces and accelerations.
void check_contacting_cells(const TemporaryFolder& folder, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::cell_files
