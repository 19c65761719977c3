#pragma once

#include <vector>

#include "verification/check/case.hpp"

namespace talus::verification {

/// The cases listed in verification/problems/CMakeLists.txt, in that order. Generated: a listed case without its
/// function does not link.
[[nodiscard]] std::vector<Case> all_cases();

}  // namespace talus::verification
