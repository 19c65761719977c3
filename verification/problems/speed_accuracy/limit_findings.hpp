#pragma once

#include "verification/problems/speed_accuracy/measured_growth.hpp"

/// Where the growth of a method begins: runs on both sides of every limit, the limits themselves, and what the solver's
/// advice on steps says of them.
namespace talus::verification::problems {

/// Runs at .98, .999, 1.001 and 1.02 of the exact limits of a method; `worst_run` keeps the worst share of error of the
/// growth of long ones.
void check_both_sides(const FixedStepMethod& method, Findings& findings, const Setup& setup, double& worst_run);

/// The steps at which runs begin to grow, of all methods at six dampings, against the exact ones, and the solver's
/// advice against them.
void check_limits(Findings& findings, const Setup& setup);

/// Euler's and Taylor's methods grow at any step where nothing damps.
void check_growth_undamped(Findings& findings, const Setup& setup);

/// The limit 2/w of Eq. 25 against those of a contact with a dashpot.
void check_common_limit(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
