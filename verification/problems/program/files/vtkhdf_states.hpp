#pragma once

#include "verification/check/case.hpp"
#include "verification/study/program/program_run.hpp"

/// States of runs in one file, written by `talus_vtkhdf`; part of the case `converted_files`.
namespace talus::verification::problems::converted_files {

/// Compares the states of such files of a scene and of a cell, step by step as a reader of VTKHDF finds them, with
/// those of the files for ParaView. The folder receives the files.
void check_vtkhdf_states(const TemporaryFolder& folder, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::converted_files
