#pragma once

#include <string>

#include "solver/app/run/step_parts.hpp"
#include "solver/io/output/run_record.hpp"

namespace talus::app {

/// The summary of a run as text: verdict and quality, outcome, method and counts, final state, energy balance; with
/// `all` also the computing time of a step, all bodies, and the extremes of every quantity.
[[nodiscard]] std::string run_summary(const RunRecord& record, const StepParts::Found& parts, bool all);

}  // namespace talus::app
