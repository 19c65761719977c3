#pragma once

#include "verification/study/program/program_options.hpp"

/// Sweeps with runs that fail; part of the case `swept_scenes`.
namespace talus::verification::problems::swept_scenes {

/// Compares the rows of runs that fail with their reasons, the exit statuses and the counts with the expected ones.
void check_failures(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::swept_scenes
