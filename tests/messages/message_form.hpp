#pragma once

#include <string>
#include <vector>

/// Error messages that the tests provoked, grouped by form.
namespace talus::messages {

/// Messages that differ in names and numbers only.
struct Form {
  std::string kind;     ///< "input": exit status 2, or "file": exit status 4
  std::string text;     ///< with ... for names and N for numbers, without the position in front
  std::string example;  ///< the shortest of them, with its position
};

/// A line of a message without the folders of its paths and other text that changes from run to run.
[[nodiscard]] std::string lasting(const std::string& line);

/// The text of a message without the position (file, line, table, field), names, numbers and lists of known names.
[[nodiscard]] std::string form_of(const std::string& line);

/// The forms of recorded lines (recorder.cpp), by kind and text. Lines of the programs in `ignored` are omitted.
/// Errors: std::runtime_error for a line that no recorder wrote.
[[nodiscard]] std::vector<Form> forms_of(const std::vector<std::string>& recorded,
                                         const std::vector<std::string>& ignored);

}  // namespace talus::messages
