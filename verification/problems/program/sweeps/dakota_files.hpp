#pragma once

#include "verification/study/program/program_options.hpp"

/// Runs that Dakota requests by files; part of the case `swept_scenes`.
namespace talus::verification::problems::swept_scenes {

/// Compares the files of results for parameters files, written here in Dakota's format, with the closed form, and the
/// messages of wrong ones. The folder has the scene ball.toml.
void check_dakota(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::swept_scenes
