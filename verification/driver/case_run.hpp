#pragma once

#include "verification/check/record.hpp"

namespace talus::verification {

/// Runs one case in this process: the right setup; the right setup again at the coarse resolution of the controls; then
/// each planted fault at that resolution, as in the quick tier. What the case throws becomes Status::error with its words.
/// Of an earlier record, if there is one, the controls are reused.
[[nodiscard]] Record run_case(const Case& verification_case, Tier tier, const Record* earlier = nullptr);

/// The record of a case that could not be run to its end: nothing checked, every control missing.
[[nodiscard]] Record unfinished(const Case& verification_case, Status status, const std::string& message);

/// What checks and controls of a finished case add up to: fills `status` (pass or fail) and `message`.
void judge(Record& record);

}  // namespace talus::verification
