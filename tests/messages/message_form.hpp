#pragma once

#include <string>
#include <vector>

/// Error messages as the tests provoked them, by what they have in common.
namespace talus::messages {

/// Messages that differ in names and numbers alone.
struct Form {
  std::string kind;     ///< "input": exit status 2, or "file": exit status 4
  std::string text;     ///< with ... for names and N for numbers, without the place in front
  std::string example;  ///< the shortest of them, with its place
};

/// A line of a message without the folders of its paths and what else changes from run to run.
[[nodiscard]] std::string lasting(const std::string& line);

/// Its text without the place (file, line, table, field), names, numbers and lists of known names.
[[nodiscard]] std::string form_of(const std::string& line);

/// The forms of recorded lines (recorder.cpp), by kind and text. Lines of the programs in `ignored` are left out.
/// Errors: std::runtime_error for a line that no recorder wrote.
[[nodiscard]] std::vector<Form> forms_of(const std::vector<std::string>& recorded,
                                         const std::vector<std::string>& ignored);

}  // namespace talus::messages
