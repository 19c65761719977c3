#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// Both sides of the linear limit of the leapfrog methods, on contacts that stay closed (squeezed_disc.hpp), and the
/// solver's advice on it. Fault `step_too_long`: the step is 3 % longer than said.
void check_linear_limit(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
