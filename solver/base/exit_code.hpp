#pragma once

namespace talus::app {

/// Exit codes of the commands.
enum ExitCode : int { ok = 0, bad_input = 2, diverged = 3, io_failed = 4, refused = 5 };

}  // namespace talus::app
