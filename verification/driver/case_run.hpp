#pragma once

#include "verification/check/record.hpp"

namespace talus::verification {

/// Runs one case in this process: the correct setup; the correct setup again at the coarse resolution of the controls;
/// then each injected fault at that resolution, as in the quick tier. An exception becomes Status::error with its
/// message. The controls of an earlier record are reused if it is given.
[[nodiscard]] Record run_case(const Case& verification_case, Tier tier, const Record* earlier = nullptr);

/// The record of a case that did not finish: no checks, every control missing.
[[nodiscard]] Record unfinished(const Case& verification_case, Status status, const std::string& message);

/// Determines the status of a finished run of the case from its checks and controls: fills `status` (pass or fail) and
/// `message`.
void judge(const Case& verification_case, Record& record);

}  // namespace talus::verification
