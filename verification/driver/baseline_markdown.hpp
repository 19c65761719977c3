#pragma once

#include <string>

#include "verification/driver/baseline.hpp"

namespace talus::verification {

/// The comparison as a job summary in GitHub's Markdown (also GitLab's): verdict, totals, a table of the first 100
/// worse items, then changed, new and gone items, and times. All lists are limited: GitHub accepts 1 MB per step.
[[nodiscard]] std::string markdown_of(const Comparison& comparison);

}  // namespace talus::verification
