#pragma once

#include <string>

#include "solver/io/output/run_record.hpp"
#include "solver/io/scene/scene_file.hpp"
#include "solver/scenes/fence_summary.hpp"

namespace talus {

/// sheet.json: the numbers and drawings of the engineer's sheet of a fence, for talus_report and for other programs.
/// All in SI: m, kg, s, N, J, rad; a number that is not finite is the text "inf". Meanings: see scenes::FenceSummary.
[[nodiscard]] std::string sheet_json(const RunRecord& record, const FenceInput& input, const Dynamics& dynamics,
                                     const scenes::FenceMonitor& watch, const State& end);

}  // namespace talus
