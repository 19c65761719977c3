#pragma once

#include "verification/check/case.hpp"
#include "verification/study/program/program_run.hpp"

/// A cell that is resumed; part of the case `cell_files`.
namespace talus::verification::problems::cell_files {

/// Compares all files of a cell whose choices were given on the command line, and which was resumed from its first
/// checkpoint, with those of the same cell in one run.
void check_interrupted(const TemporaryFolder& folder, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::cell_files
