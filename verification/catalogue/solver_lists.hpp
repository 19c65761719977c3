#pragma once

#include <vector>

#include "verification/catalogue/requirement.hpp"

namespace talus::verification {

/// One requirement for each member of the solver's closed lists, in the order of the report: laws, end rules, contact
/// methods, mechanisms, integrators, shapes, pairs of shapes, regimes.
[[nodiscard]] std::vector<Requirement> requirements_of_solver();

}  // namespace talus::verification
