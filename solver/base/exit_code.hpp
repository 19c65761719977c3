#pragma once

namespace talus::app {

/// Exit statuses of the commands. 1 and 6 are those of talus_verify.
enum ExitCode : int {
  ok = 0,
  bad_input = 2,
  diverged = 3,
  io_failed = 4,
  refused = 5,
  unusable = 7,  ///< the run ended, but its results are not usable; of `check`: its step is beyond the linear limit,
                 ///< or its run monitor would end the run at the start
};

}  // namespace talus::app
