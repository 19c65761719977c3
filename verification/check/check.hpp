#pragma once

#include <string>

#include "verification/check/tolerance.hpp"
#include "verification/record/check.hpp"

namespace talus::verification {

using records::Check;

/// Compares `measured` with `reference`. A number that is not finite fails, as does a relative error from zero.
[[nodiscard]] Check compare(std::string name, double measured, double reference, const Tolerance& tolerance,
                            std::string unit);

/// Checks `low <= measured <= high`, as the error from the midpoint relative to half the width. Errors:
/// std::invalid_argument if the range is empty or not finite, or if the justification is missing.
[[nodiscard]] Check compare_between(std::string name, double measured, double low, double high, std::string why,
                                    std::string unit);

}  // namespace talus::verification
