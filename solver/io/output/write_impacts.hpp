#pragma once

#include <optional>
#include <span>
#include <string>

#include "solver/io/output/run_record.hpp"
#include "solver/run/history.hpp"

namespace talus {

/// A number of an impact.
struct ImpactColumn {
  Column column;
  /// Nothing if it does not exist, as the separation of an impact that has not ended.
  std::optional<double> (*value)(const RecordedImpact&);
};

/// All of them, see RecordedImpact.
[[nodiscard]] std::span<const ImpactColumn> impact_columns();

/// impacts.csv: a row for each impact of the run; numbers that do not exist are empty cells. The record must have
/// impacts.
[[nodiscard]] std::string impacts_csv(const RunRecord& record);

}  // namespace talus
