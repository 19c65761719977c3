/// The switch of mutants, for the copy of the sources into which they are compiled. No other build includes it.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace talus::mutants {

/// Maximum number of mutants in one build.
inline constexpr int capacity = 1 << 16;

/// Number of the mutant that is switched on; 0: none; -1: none, and mutants that are reached are recorded. Before it is
/// initialised no mutant is on. Programs started by a case get it from the environment.
inline int active = [] {
  const char* const number = std::getenv("TALUS_MUTANT");
  return number == nullptr ? 0 : std::atoi(number);
}();

/// By number of the mutant: nonzero if it was evaluated since recording began.
inline unsigned char reached[capacity] = {};

/// Appends the numbers of the mutants that were reached to the file named by TALUS_MUTANTS_REACHED, if set.
inline void write_reached() {
  const char* const name = std::getenv("TALUS_MUTANTS_REACHED");
  std::FILE* const file = name == nullptr ? nullptr : std::fopen(name, "a");
  if (file == nullptr) return;
  for (int number = 0; number < capacity; ++number) {
    if (reached[number] != 0) std::fprintf(file, "%d\n", number);
  }
  std::fclose(file);
}

/// Writes the reached mutants when the program ends.
inline struct Ending {
  ~Ending() { write_reached(); }
} ending;

/// True if mutant `number` is switched on; false in constant expressions.
constexpr bool on(int number) {
  if (__builtin_is_constant_evaluated()) return false;
  const int now = active;
  if (now < 0) [[unlikely]] {
    reached[number] = 1;
    return false;
  }
  return now == number;
}

}  // namespace talus::mutants
