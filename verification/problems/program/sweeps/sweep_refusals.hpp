#pragma once

#include "verification/study/program/program_options.hpp"

/// Wrong sweeps; part of the case `swept_scenes`.
namespace talus::verification::problems::swept_scenes {

/// Compares the messages of wrong sweeps and commands, with file, line and key. The folder has the scene ball.toml and
/// a sweep that has been run, `grid`.
void check_refusals(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::swept_scenes
