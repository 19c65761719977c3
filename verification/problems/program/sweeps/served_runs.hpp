#pragma once

#include "verification/study/program/program_options.hpp"

/// Runs that clients of UM-Bridge request from `talus_serve`; part of the case `swept_scenes`.
namespace talus::verification::problems::swept_scenes {

/// Compares the outputs of served runs with the closed form, and the answers to runs that are refused or fail with the
/// protocol. The folder has the scene ball.toml.
void check_server(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::swept_scenes
