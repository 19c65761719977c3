#pragma once

#include <cfenv>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "verification/check/record.hpp"

namespace talus::verification {

/// Settings for running the selected cases.
struct RunPlan {
  std::filesystem::path out;  ///< Each case writes into out/ID.
  unsigned jobs = 1;          ///< Number of cases that run at the same time, each in a separate process.
  Tier tier = Tier::quick;
  int rounding = FE_TONEAREST;  ///< Rounding of the floating-point unit while a case runs (<cfenv>).
  std::string program{};        ///< Fingerprint that marks the records; empty: no mark.
  bool reuse = false;           ///< Reuse records of this program in `out`.
};

/// Called when a case ends, with its record, the cases that are still running, and whether the record was reused.
using Progress = std::function<void(const Record& ended, const std::vector<std::string>& running, bool reused)>;

/// Runs each case in a child process and reads its record strictly. A crash, a non-zero exit status, a time or memory
/// above the case's limit, and a record that is missing, empty, truncated or inconsistent become failed records; the
/// other cases continue. The same holds if the system cannot start a process or if this process has no memory for a
/// record. With `reuse`, a case that has a record of this program is not run if it has no full part; otherwise only its
/// controls are not run. Returns one record for each case, in the order of `cases`. Errors: std::runtime_error if a
/// folder cannot be created.
[[nodiscard]] std::vector<Record> run_all(const std::vector<Case>& cases, const RunPlan& plan,
                                          const Progress& progress);

}  // namespace talus::verification
