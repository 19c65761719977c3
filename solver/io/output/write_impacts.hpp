#pragma once

#include <string>

#include "solver/io/output/run_record.hpp"

namespace talus {

/// impacts.csv: a row for each impact of the run, see RecordedImpact. Numbers that do not exist, as the separation of
/// an impact that has not ended, are empty cells. The record must have impacts.
[[nodiscard]] std::string impacts_csv(const RunRecord& record);

}  // namespace talus
