#pragma once

#include <vector>

#include "verification/check/case.hpp"

namespace talus::verification {

/// The command `talus_verify` on the given cases. Returns the exit status: 0 if every check holds and every control
/// turned red, 1 if not, 2 for a wrong command line, 4 if results cannot be written.
[[nodiscard]] int verify(const std::vector<Case>& cases, int argc, const char* const* argv);

}  // namespace talus::verification
