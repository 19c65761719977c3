#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// Momentum about the pin and the ledger during the impact, without gravity. Fault `rk4`.
void check_ledger(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
