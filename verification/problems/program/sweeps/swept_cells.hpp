#pragma once

#include "verification/study/program/program_options.hpp"

/// Shear cells as the base of a sweep; part of the case `swept_scenes`.
namespace talus::verification::problems::swept_scenes {

/// Compares the groups of swept cells with the closed forms of their fields, all numbers with those of `talus cell`,
/// their units, a fitted field, and the ends of runs with warnings, limits and wrong fields.
void check_cells(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::swept_scenes
