#pragma once

#include "verification/check/findings.hpp"
#include "verification/study/program/program_options.hpp"

/// Rocks that are expected at a fence; part of the case `fence_capacity`.
namespace talus::verification::problems::fence_capacity {

/// The probability of failure of lognormal speeds beside the closed form.
void check_hazard(const Program& program, Findings& findings, Differences& differ);

/// Rocks whose mass, speed and height are all drawn: lognormal, and independent of each other.
void check_drawn_rocks(const Program& program, Findings& findings, Differences& differ);

}  // namespace talus::verification::problems::fence_capacity
