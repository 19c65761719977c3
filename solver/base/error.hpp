#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// The user's input is wrong. The message names what was found and what is allowed; the place (file, line, field) is
/// put in front by whoever knows it. Caught once, in main: exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file cannot be read or written; the message names the file and the system's reason. Exit code 4.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The known name nearest to `found` by edit distance; empty if `known` is empty.
[[nodiscard]] std::string nearest_name(std::string_view found, const std::vector<std::string>& known);

/// "integrator 'verlett' is not known; nearest: velocity_verlet; known: ..." — `kind` is the noun in front; of the
/// known names the first 60.
[[nodiscard]] InputError unknown_name(std::string_view kind, std::string_view found,
                                      const std::vector<std::string>& known);

/// Reports a broken contract between parts of the program (never the user's mistake) and aborts.
[[noreturn]] void demand_failed(const char* condition, const char* file, int line);

}  // namespace talus

/// Aborts with condition and place unless it holds, in every build: for the programmer's mistakes only.
#define TALUS_DEMAND(condition)                                               \
  do {                                                                        \
    if (!(condition)) ::talus::demand_failed(#condition, __FILE__, __LINE__); \
  } while (false)

/// As TALUS_DEMAND, in builds without NDEBUG only: for conditions inside a step.
#ifdef NDEBUG
#define TALUS_ASSERT(condition) static_cast<void>(0)
#else
#define TALUS_ASSERT(condition) TALUS_DEMAND(condition)
#endif
