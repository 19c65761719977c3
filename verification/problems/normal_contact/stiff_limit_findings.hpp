#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// How a bounce with weight tends to that of a rigid plane as the contact grows stiff.
void check_stiff_limit(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
