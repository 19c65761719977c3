#pragma once

#include "verification/study/program/program_options.hpp"

/// Fences as the base of a sweep; part of the case `swept_scenes`.
namespace talus::verification::problems::swept_scenes {

/// Compares the runs of swept fences, a scene's and a deck's of 1993, with those of `talus run` of the changed file,
/// bit by bit.
void check_fences(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::swept_scenes
