#pragma once

#include <string>

#include "solver/io/run_record.hpp"

namespace talus::app {

/// The summary of a run as text: outcome, method and counts, final state, extremes, ledger with its closures.
[[nodiscard]] std::string run_summary(const RunRecord& record);

}  // namespace talus::app
