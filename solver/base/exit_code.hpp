#pragma once

#include <cstddef>

namespace talus::app {

/// Exit statuses of the commands. 1 is that of talus_verify, which also uses 6: worse than the baseline.
enum ExitCode : int {
  ok = 0,
  bad_input = 2,
  diverged = 3,
  io_failed = 4,
  refused = 5,
  some_failed = 6,  ///< some runs of a sweep failed; if all did, it is `diverged`
  unusable = 7,     ///< the run ended, but its results are not usable; of `check`: its step is beyond the linear limit,
                    ///< or its run monitor would end the run at the start
};

/// Exit status of a command that executes several runs.
constexpr ExitCode exit_of_runs(std::size_t failed, std::size_t all) {
  if (failed == 0) return ok;
  return failed == all ? diverged : some_failed;
}

}  // namespace talus::app
