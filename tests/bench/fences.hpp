#pragma once

namespace talus::bench {

/// Prints what a step costs of the fence of the 1993 report's Table 2 (600 lb rock, centre hit, .5 ft slack, elastic
/// cables) as that program ran it, for one and two layers and for 13, 101 and 1,001 columns: the mean over .2 s at the
/// report's step of 2e-6 s, without output.
void print_fence_costs();

}  // namespace talus::bench
