#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tests/mutants/mutant.hpp"

namespace talus::mutants {

/// An edit and the number that switches it on (> 0).
struct Switched {
  Edit edit{};
  int number{};
};

/// The text of a file with its edits compiled in, each behind its switch. Edits may lie in one another; in what replaces
/// one the others are left out, for one mutant at a time is on. Lines keep their numbers as long as no replacement has
/// more than one. Errors: std::invalid_argument if two edits cross each other.
[[nodiscard]] std::string with_switches(std::string_view text, std::span<const Switched> edits);

/// Number of the mutant whose switch is the last one at or before a place of a text with switches; 0 if its line has
/// none before it. `line` and `column` count from 1, columns in bytes.
[[nodiscard]] int switch_at(std::string_view text, std::size_t line, std::size_t column);

}  // namespace talus::mutants
