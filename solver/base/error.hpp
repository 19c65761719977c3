#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// Error in the user's input. The message states what was found and what is allowed; the caller that knows the location
/// (file, line, field) prepends it. Caught once, in main: exit status 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Failure to read or write a file; the message names the file and the system's reason. Exit status 4.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The known name nearest to `found` by edit distance; empty if `known` is empty.
[[nodiscard]] std::string nearest_name(std::string_view found, const std::vector<std::string>& known);

/// Error "integrator 'verlett' is not known; nearest: velocity_verlet; known: ...". `kind` is the noun at its start;
/// at most the first 60 known names are listed; without any it ends in "there is none".
[[nodiscard]] InputError unknown_name(std::string_view kind, std::string_view found,
                                      const std::vector<std::string>& known);

/// Reports a violated contract between parts of the program (never a user error) and aborts.
[[noreturn]] void demand_failed(const char* condition, const char* file, int line);

}  // namespace talus

/// Aborts, in every build, with the condition and its source location unless the condition holds: for programming
/// errors only.
#define TALUS_DEMAND(condition)                                               \
  do {                                                                        \
    if (!(condition)) ::talus::demand_failed(#condition, __FILE__, __LINE__); \
  } while (false)

/// As TALUS_DEMAND, but only in builds without NDEBUG: for conditions inside a step.
#ifdef NDEBUG
#define TALUS_ASSERT(condition) static_cast<void>(0)
#else
#define TALUS_ASSERT(condition) TALUS_DEMAND(condition)
#endif
