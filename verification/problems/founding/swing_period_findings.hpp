#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// Periods from 0.1 to 179 degrees, by interpolated passages, against the elliptic integral; and by how much velocity
/// Verlet misses it, against its own theory. Faults of bob() and verlet().
void check_amplitudes(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
