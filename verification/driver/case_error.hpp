#pragma once

#include <string>
#include <vector>

#include "verification/catalogue/catalogue.hpp"
#include "verification/check/case.hpp"

namespace talus::verification {

/// What is wrong with a case before it is run, in words: a missing citation, an unknown requirement, no planted fault,
/// an id used twice. Empty if nothing is.
[[nodiscard]] std::string case_error(const Case& verification_case, const std::vector<Case>& all,
                                     const Catalogue& catalogue);

}  // namespace talus::verification
