#pragma once

#include <span>
#include <vector>

#include "verification/record/case_record.hpp"

namespace talus::records {

/// A case with its failed checks, the most urgent first; at least one.
struct FailedCase {
  const Record* record{};
  std::vector<const Check*> checks;
};

/// The cases with failed checks. The one to be read first comes first: that with the largest finite error/bound. An
/// exact check, whose bound is 0, and NaN have no size; they come last. The result refers to `records`.
[[nodiscard]] std::vector<FailedCase> failed_cases(std::span<const Record> records);

}  // namespace talus::records
