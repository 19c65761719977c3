#pragma once

#include "verification/check/case.hpp"
#include "verification/problems/fence/fence_ensemble.hpp"

namespace talus::verification::problems {

/// What each choice that the report does not tell moves: the mean distances to Tables 2 and 3 with that choice made
/// otherwise (full tier), and that the unknown end of the bottom cable moves nothing.
void check_choices(Findings& findings, const std::vector<RowRun>& rows, const Setup& setup);

}  // namespace talus::verification::problems
