#pragma once

#include "verification/check/findings.hpp"

namespace talus::verification::problems {

/// Figs. 12 and 13 of the report: where the 600 lb rock and the central column are at some times of the impact, with
/// the bottom cable (.5 ft slack) and without.
void draw_snapshots(Findings& findings);

}  // namespace talus::verification::problems
