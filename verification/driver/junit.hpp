#pragma once

#include <string>
#include <vector>

#include "verification/check/record.hpp"

namespace talus::verification {

/// Text as XML 1.0 character data or attribute value: markup is escaped, and characters that XML does not allow are
/// replaced by '?'.
[[nodiscard]] std::string escaped(const std::string& text);

/// JUnit XML: one test suite for each case, one test case for each check and control, and one named `run` for the case
/// itself, with the case's time [s]. Checks and controls have a time of 0, so that the times of a suite sum to that of
/// its case; their properties are measured, reference, error, bound, unit, relative and kind.
[[nodiscard]] std::string junit_of(const std::vector<Record>& records);

}  // namespace talus::verification
