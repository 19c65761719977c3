#pragma once

#include "verification/study/program/program_options.hpp"

/// Wrong questions about capacities; part of the case `fence_capacity`.
namespace talus::verification::problems::fence_capacity {

/// Compares the messages of wrong files, with file, line and key, and shows that nothing is written.
void check_refusals(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::fence_capacity
