#pragma once

#include "verification/check/case.hpp"
#include "verification/problems/fence/fence_ensemble.hpp"

namespace talus::verification::problems {

/// The relation between the peaks of joint and top cable: our runs obey it, and of the printed pairs three do not.
/// Fault `mass_doubled`.
void check_pairs(Findings& findings, const std::vector<RowRun>& rows, const Setup& setup);

}  // namespace talus::verification::problems
