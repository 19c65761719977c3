#pragma once

#include <string>

#include "solver/io/run_record.hpp"

namespace talus {

/// summary.json: title, outcome, method, counts, energies with their closure, momenta, extremes; numbers in the scene's
/// units, which `units` names. A number that is not finite is written as the text "nan", "inf" or "-inf". With
/// `resume`, the command that takes the run on, that too.
[[nodiscard]] std::string summary_json(const RunRecord& record, const std::string& resume = {});

/// final_state.json: time, and position, angle, velocity and spin of each body.
[[nodiscard]] std::string final_state_json(const RunRecord& record);

}  // namespace talus
