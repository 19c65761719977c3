#pragma once

#include "verification/check/case.hpp"
#include "verification/study/program/program_run.hpp"

/// The last row of the history of a cell, and whether its means are steady; part of the case `cell_files`.
namespace talus::verification::problems::cell_files {

/// Runs a cell whose last LOOP is a single step, one that fails within a LOOP, and one whose load is lifted.
void check_last_rows(const TemporaryFolder& folder, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::cell_files
