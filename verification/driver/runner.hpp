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
};

/// Told when a case ends (its record) and which cases are still running.
using Progress = std::function<void(const Record& ended, const std::vector<std::string>& running)>;

/// Runs each case in a child process and reads back what it left, strictly. A crash, an exit status other than zero,
/// more time or memory than the case may take, and a record that is missing, empty, truncated or inconsistent become
/// failed records; the others go on. So do a process that the system refuses and a record for which this process has no
/// memory. Returns one record for each case, in the order of `cases`. std::runtime_error if a folder cannot be made.
[[nodiscard]] std::vector<Record> run_all(const std::vector<Case>& cases, const RunPlan& plan,
                                          const Progress& progress);

}  // namespace talus::verification
