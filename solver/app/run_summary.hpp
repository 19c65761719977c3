#pragma once

#include <string>

#include "solver/app/step_parts.hpp"
#include "solver/io/run_record.hpp"

namespace talus::app {

/// The summary of a run as text: outcome, method and counts, what its steps carried and cost, final state, extremes,
/// ledger with its closures.
[[nodiscard]] std::string run_summary(const RunRecord& record, const StepParts::Found& parts);

}  // namespace talus::app
