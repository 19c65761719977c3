#pragma once

#include <string>

#include "verification/driver/baseline.hpp"

namespace talus::verification {

/// The comparison as a job summary in GitHub's Markdown (also GitLab's): verdict, totals, a table of the first 100
/// items that are worse, then what changed, is new or gone, and times. All lists are limited: GitHub takes 1 MB a step.
[[nodiscard]] std::string markdown_of(const Comparison& comparison);

}  // namespace talus::verification
