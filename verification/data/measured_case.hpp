#pragma once

#include <filesystem>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/data/measured_set.hpp"

namespace talus::verification {

/// The case that compares a set of measurements with runs of its scene by the built program, one for each row.
///
/// Each quantity has four checks. With E the computed less the measured value and u its standard uncertainty, u^2 =
/// u_D^2 + u_in^2 + u_num^2 + u_model^2 (measured value; inputs, by the change of the result with each; method, by the
/// change with half the step or a tenth of the tolerance; model): the root mean square of E/u, its largest value and
/// its mean must be such as 99 % of sets have if E is normal with standard deviation u, independent from row to row;
/// and u_num must not exceed a fifth of u_D (this check is not made for a method without error). ASME V&V 20-2009
/// defines E and u.
[[nodiscard]] Case measured_case(const MeasuredSet& set);

/// The cases of all sets of the folder. Errors: those of measured_files() and read_measured_set().
[[nodiscard]] std::vector<Case> measured_cases(const std::filesystem::path& folder);

}  // namespace talus::verification
