#pragma once

#include "verification/check/case.hpp"

/// The statistics of maps and intervals, without a fence; part of the case `fence_capacity`.
namespace talus::verification::problems::fence_capacity {

/// Counts how often intervals contain what they are for, beside their exact coverage.
void check_coverage(Findings& findings, const Setup& setup);

/// Maps of a known probability, beside the full grid and the exact line of one half.
void check_maps(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::fence_capacity
