#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// A disc pressed by hand along a path with reloads inside the hysteresis loop, out of slackness and after parting:
/// forces and work against straight lines, to the last bit.
void check_latching_path(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
