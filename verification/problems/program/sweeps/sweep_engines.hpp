#pragma once

#include <string>

#include "verification/study/program/program_options.hpp"

/// Engines that run the parts of a sweep; part of the case `swept_scenes`.
namespace talus::verification::problems::swept_scenes {

/// Compares the commands that the engines are given, by programs of their names that start the parts one after the
/// other, and their table with that of the folder `grid`, which the sweep has been run in.
void check_engines(const Program& program, const std::string& sweep, Differences& differ);

}  // namespace talus::verification::problems::swept_scenes
