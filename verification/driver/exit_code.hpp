#pragma once

/// How talus_verify, and the process of a case, ends.
namespace talus::verification {

inline constexpr int exit_pass = 0;   ///< every check holds
inline constexpr int exit_fail = 1;   ///< a check, a control or a case does not
inline constexpr int exit_usage = 2;  ///< wrong options
inline constexpr int exit_io = 4;     ///< a file cannot be read or written
inline constexpr int exit_worse = 6;  ///< worse than the baseline

}  // namespace talus::verification
