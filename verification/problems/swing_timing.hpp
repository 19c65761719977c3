#pragma once

#include "verification/check/findings.hpp"

namespace talus::verification::problems {

/// Draws error against time for every fixed-step method on the 60 degree swing: the median of 15 repetitions, all
/// methods and steps interleaved in a shuffled order, with bars from the fastest to the slowest. A picture of this
/// machine; nothing is checked on it. For the full tier.
void chart_error_against_time(Findings& findings);

}  // namespace talus::verification::problems
