#pragma once

#include <string>
#include <vector>

#include "solver/io/output/run_record.hpp"

namespace talus::app {

/// Result of a run in the scene's units: a fence's verdict with its largest forces, or another scene's last contact,
/// and the quality of the results. Each line begins with its subject, padded to a column.
[[nodiscard]] std::vector<std::string> verdict_lines(const RunRecord& record);

}  // namespace talus::app
