#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "solver/io/output/run_record.hpp"

namespace talus {

/// summary.json: title, outcome, quality, verdict of a fence, method, counts, energies and momenta with their balance
/// errors, extremes, and `resume`, the command that resumes the run, unless it is empty. Numbers are in the scene's
/// units, which `units` names. A number that is not finite is written as the text "nan", "inf" or "-inf".
[[nodiscard]] std::string summary_json(const RunRecord& record, const std::string& resume = {});

/// The entry `quality` of summary.json and sheet.json. `time_size` is the size of the scene's unit of time in the
/// file's.
[[nodiscard]] nlohmann::ordered_json quality_json(const RunQuality& quality, double time_size = 1.0);

/// final_state.json: time; position, angle, velocity and spin of each body; mode and plastic stretch of each cable and
/// hanger.
[[nodiscard]] std::string final_state_json(const RunRecord& record);

}  // namespace talus
