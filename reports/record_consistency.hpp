#pragma once

#include <vector>

#include "reports/record.hpp"

namespace talus::reports {

class Node;

/// The numbers as they follow from the records themselves.
[[nodiscard]] Counts counted(const std::vector<CaseRecord>& cases);

/// Number registered (and asked for) = number run = number in the report, and the verdict follows from the records.
/// Throws RecordError, naming the field of `root` that says otherwise.
void demand_consistency(const Node& root, const Results& results);

}  // namespace talus::reports
