#pragma once

#include "verification/check/case.hpp"
#include "verification/study/program/program_run.hpp"

/// Cells as LAMMPS reads them, written by `talus export`; part of the case `converted_files`.
namespace talus::verification::problems::converted_files {

/// Compares the commands and the discs of cells with closed forms, as far as the setup needs these checks. The folder
/// receives the files.
void check_exported_cells(const TemporaryFolder& folder, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::converted_files
