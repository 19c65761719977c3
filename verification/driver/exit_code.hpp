#pragma once

/// Exit statuses of talus_verify and of the process of a case.
namespace talus::verification {

inline constexpr int exit_pass = 0;   ///< all checks and controls pass
inline constexpr int exit_fail = 1;   ///< a check, a control or a case fails
inline constexpr int exit_usage = 2;  ///< invalid options
inline constexpr int exit_io = 4;     ///< a file cannot be read or written
inline constexpr int exit_worse = 6;  ///< worse than the baseline

}  // namespace talus::verification
