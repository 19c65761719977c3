#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "solver/io/output/run_record.hpp"

namespace talus {

/// summary.json: title, outcome, quality, of a fence its verdict, method, counts, energies with their closure, momenta,
/// extremes; numbers in the scene's units, which `units` names. A number that is not finite is written as the text
/// "nan", "inf" or "-inf". With `resume`, the command that takes the run on, that too.
[[nodiscard]] std::string summary_json(const RunRecord& record, const std::string& resume = {});

/// The quality in summary.json and sheet.json. `time_size`: of the unit of time in that file's.
[[nodiscard]] nlohmann::ordered_json quality_json(const RunQuality& quality, double time_size = 1.0);

/// final_state.json: time, and position, angle, velocity and spin of each body.
[[nodiscard]] std::string final_state_json(const RunRecord& record);

}  // namespace talus
