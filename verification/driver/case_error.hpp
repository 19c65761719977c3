#pragma once

#include <string>
#include <vector>

#include "verification/catalogue/catalogue.hpp"
#include "verification/check/case.hpp"

namespace talus::verification {

/// Error in the definition of a case, found before it runs: a missing citation, an unknown requirement, no injected
/// fault, an id used twice. Empty if the case is valid.
[[nodiscard]] std::string case_error(const Case& verification_case, const std::vector<Case>& all,
                                     const Catalogue& catalogue);

}  // namespace talus::verification
