#pragma once

#include "verification/study/program/program_run.hpp"

/// Energy scales of bodies whose stored energy becomes heat; part of the case `run_files`.
namespace talus::verification::problems::run_files {

/// Energy scales of two scenes over the largest change of an energy in their rows, of which there is one for each
/// step: largest deviation from 1; 1 if that energy is not the stored one.
[[nodiscard]] double scale_error(const TemporaryFolder& folder);

}  // namespace talus::verification::problems::run_files
