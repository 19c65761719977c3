#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// The step at which a dashpot that sees an old velocity makes a contact grow, half a step old and one and a half,
/// against the closed forms and against 2/w: a check for each and a table.
void check_lagged_limits(Findings& findings);

}  // namespace talus::verification::problems
