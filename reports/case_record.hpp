#pragma once

#include "reports/record.hpp"

namespace talus::reports {

class Node;

/// One case of results.json. Throws RecordError (file and field) when it is not what the schema says or contradicts
/// itself: a name occurs twice, or the case passes without a check or with a failed one.
[[nodiscard]] CaseRecord case_of(const Node& node);

}  // namespace talus::reports
