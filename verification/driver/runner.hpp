#pragma once

#include <cfenv>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "verification/check/record.hpp"

namespace talus::verification {

/// How the chosen cases are run.
struct RunPlan {
  std::filesystem::path out;  ///< Each case writes into out/ID.
  unsigned jobs = 1;          ///< Cases at once, each in its own process.
  Tier tier = Tier::quick;
  int rounding = FE_TONEAREST;  ///< Rounding of the floating-point unit while a case runs (<cfenv>).
  std::string program{};        ///< What marks the records; empty: nothing does.
  bool reuse = false;           ///< Reuse what this program's records in `out` have in common with this run.
};

/// Called when a case ends, with its record, the cases that are still running, and whether the record was reused.
using Progress = std::function<void(const Record& ended, const std::vector<std::string>& running, bool reused)>;

/// Runs each case in a child process and reads back what it left, strictly. A crash, an exit status other than zero,
/// more time or memory than the case may take, and a record that is missing, empty, truncated or inconsistent become
/// failed records; the others go on. So do a process that the system refuses and a record for which this process has no
/// memory. With `reuse` a case without a full part that has a record of this program is not run, and of one with a full
/// part the controls are not. Returns one record for each case, in the order of `cases`. std::runtime_error if a folder cannot be made.
[[nodiscard]] std::vector<Record> run_all(const std::vector<Case>& cases, const RunPlan& plan,
                                          const Progress& progress);

}  // namespace talus::verification
