#pragma once

#include <string>
#include <vector>

#include "solver/io/output/run_record.hpp"

namespace talus::app {

/// What a run came to, in the scene's units: a fence's verdict with its largest forces, the last contact of another
/// scene, and how far the results can be trusted. Each line begins with its subject, padded to a column.
[[nodiscard]] std::vector<std::string> verdict_lines(const RunRecord& record);

}  // namespace talus::app
