/// Coverage of the solver's features by the cases. All results are Markdown.
#pragma once

#include <string>

#include "reports/base/record.hpp"
#include "verification/record/mutants.hpp"

namespace talus::reports {

/// Number of checks for each of: laws and their regimes, laws with end rules and methods, integrators and orders, pairs
/// of shapes in contact, terms of the energy balance and outputs of the program, by the requirements that the cases
/// claim; empty cells read "none". With `mutants` (may be null), also the number of mutants that these checks detected.
[[nodiscard]] std::string coverage(const Results& results, const records::Mutants* mutants);

}  // namespace talus::reports
