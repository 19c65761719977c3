#pragma once

namespace talus::app {

/// The exit codes that a command can end with.
enum ExitCode : int { ok = 0, bad_input = 2, diverged = 3, io_failed = 4, refused = 5 };

}  // namespace talus::app
