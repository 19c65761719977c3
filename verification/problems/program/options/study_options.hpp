#pragma once

#include "verification/study/program/program_options.hpp"

/// Options and results of `talus study`; part of the case `calculation_options`.
namespace talus::verification::problems::calculation_options {

/// Compares runs of a study with other options, its printed table with its runs, and one of these with the same cell
/// run by `talus cell`.
void check_study(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::calculation_options
