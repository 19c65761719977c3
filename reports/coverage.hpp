/// What the cases cover, and what they do not. All results are Markdown.
#pragma once

#include <string>

#include "reports/record.hpp"
#include "verification/record/mutants.hpp"

namespace talus::reports {

/// Laws and their regimes, laws with end rules and methods, integrators and orders, pairs of shapes in contact, sums of the
/// energy balance and outputs of the program: the number of checks of each, by the requirements that the cases claim;
/// empty cells say "none". With `mutants`, which may be null, also how many of them these checks noticed.
[[nodiscard]] std::string coverage(const Results& results, const records::Mutants* mutants);

}  // namespace talus::reports
