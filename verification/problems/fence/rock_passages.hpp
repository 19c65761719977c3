#pragma once

#include "verification/check/case.hpp"

/// Passages of rocks that come from either side, fall or creep, for the case `second_rock`.
namespace talus::verification::problems {

void check_passages(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
