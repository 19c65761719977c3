/// The switch of mutants, for the copy of the sources in which they are compiled. No other build includes it.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace talus::mutants {

/// Largest number of mutants in one build.
inline constexpr int capacity = 1 << 16;

/// Number of the mutant that is switched on; 0: none; -1: none, and those that are reached are recorded. Before it is
/// initialised no mutant is on. Programs started by a case get it from the environment.
inline int active = [] {
  const char* const number = std::getenv("TALUS_MUTANT");
  return number == nullptr ? 0 : std::atoi(number);
}();

/// Whether a mutant was evaluated since recording began, by its number.
inline unsigned char reached[capacity] = {};

/// Adds the numbers of those that were reached to the file TALUS_MUTANTS_REACHED names, if any.
inline void write_reached() {
  const char* const name = std::getenv("TALUS_MUTANTS_REACHED");
  std::FILE* const file = name == nullptr ? nullptr : std::fopen(name, "a");
  if (file == nullptr) return;
  for (int number = 0; number < capacity; ++number) {
    if (reached[number] != 0) std::fprintf(file, "%d\n", number);
  }
  std::fclose(file);
}

/// Writes what a program reached when it ends.
inline struct Ending {
  ~Ending() { write_reached(); }
} ending;

/// Is mutant `number` switched on? Never where a constant is evaluated by the compiler.
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
