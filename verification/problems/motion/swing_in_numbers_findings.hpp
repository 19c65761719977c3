#pragma once

#include "verification/check/case.hpp"

/// The solver's integrators of fixed step on one body that swings, in numbers of several types.
namespace talus::verification::problems {

/// Rounding after 500 steps in numbers of 24 to 113 bits against its prediction, and each method against its own map
/// in 113 bits.
void check_numbers(Findings& findings, const Setup& setup);

/// The whole error against the step: it falls by the method's order, is least where predicted, and rises by rounding.
void check_best_steps(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
