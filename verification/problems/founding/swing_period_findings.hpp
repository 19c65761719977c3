#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// Compares periods from 0.1 to 179 degrees, measured between interpolated passages, with the elliptic integral, and
/// their errors with the theory of velocity Verlet. Faults of bob() and verlet().
void check_amplitudes(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
