#pragma once

#include "solver/scenes/fence.hpp"

namespace talus::bench {

/// Scaling of the sag with the span: with the square of the span, the top cable stays equally tight.
enum class Sag { fraction_of_span, as_tight };

/// The fence of Table 2 with another number of columns: the same spacing and end segments.
[[nodiscard]] scenes::Fence long_fence(int columns, int layers, Sleep sleep, Sag sag = Sag::fraction_of_span);

/// Prints the cost of a step of the fence of the 1993 report's Table 2 (600 lb rock, centre hit, 0.5 ft slack, elastic
/// cables) as that program ran it, for one and two layers and for 13, 101 and 1,001 columns: the mean over 0.2 s at the
/// report's step of 2e-6 s, without output.
void print_fence_costs();

}  // namespace talus::bench
