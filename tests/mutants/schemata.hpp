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

/// The text of a file with its edits compiled in, each with its switch. Edits may be nested; the replacement of one
/// contains none of the others, because only one mutant is on at a time. Lines keep their numbers as long as each
/// replacement is a single line. Errors: std::invalid_argument if two edits cross each other.
[[nodiscard]] std::string with_switches(std::string_view text, std::span<const Switched> edits);

/// Number of the mutant whose switch is the last one at or before a position of a text with switches; 0 if its line has
/// none before it. `line` and `column` count from 1, columns in bytes.
[[nodiscard]] int switch_at(std::string_view text, std::size_t line, std::size_t column);

}  // namespace talus::mutants
