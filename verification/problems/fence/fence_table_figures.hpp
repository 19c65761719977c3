#pragma once

#include <vector>

#include "verification/check/findings.hpp"
#include "verification/problems/fence/fence_ensemble.hpp"

namespace talus::verification::problems {

/// Printed against computed, one figure for each quantity.
void draw_tables(Findings& findings, const std::vector<RowRun>& rows);

/// Figs. 14 and 15 again: both rocks at yc = 0 with the bottom cable, elastic and elastic-plastic.
void draw_histories(Findings& findings);

}  // namespace talus::verification::problems
