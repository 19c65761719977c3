#pragma once

#include "verification/check/case.hpp"
#include "verification/study/program/program_run.hpp"

/// The page of `talus animate` beside the states for ParaView; part of the case `two_rocks`.
namespace talus::verification::problems::two_rocks {

/// Compares the outlines of bodies and the ends and tensions of cables in the page of the run in `out` with the points
/// of its states.
void check_animation_page(const TemporaryFolder& folder, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::two_rocks
