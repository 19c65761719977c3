#pragma once

#include "verification/study/program/program_options.hpp"

/// The pictures and texts of a map, in SI and US units; part of the case `fence_capacity`.
namespace talus::verification::problems::fence_capacity {

/// Compares the pictures of a map and its boundary, as gnuplot has to draw them, the text and capacity.csv with
/// capacity.json, which is in SI units.
void check_figures(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::fence_capacity
