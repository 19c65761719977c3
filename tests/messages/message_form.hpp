#pragma once

#include <iosfwd>
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

/// The forms of recorded lines (recorder.cpp), by kind and text. Lines of the programs in `ignored` are omitted, and
/// within a message the line that names the help, and the text of another program after a line that ends in a colon.
/// Errors: std::runtime_error for a line that no recorder wrote.
[[nodiscard]] std::vector<Form> forms_of(const std::vector<std::string>& recorded,
                                         const std::vector<std::string>& ignored);

/// What to do about a message whose text does not say it.
struct Cure {
  std::string form;  ///< Form::text
  std::string cure;
};

/// The cures of a file: a line with the form, then indented lines with the cure; `#` begins a comment.
/// Errors: std::runtime_error for an indented line without a form.
[[nodiscard]] std::vector<Cure> read_cures(std::istream& in);

/// Whether the text of a message says what is allowed or what to do.
[[nodiscard]] bool names_cure(const std::string& form);

/// The cure listed for a message; empty if there is none.
[[nodiscard]] std::string cure_of(const Form& form, const std::vector<Cure>& cures);

/// Messages without a cure in their text or in the list, and entries of the list that no message has.
[[nodiscard]] std::vector<std::string> cure_errors(const std::vector<Form>& forms, const std::vector<Cure>& cures);

}  // namespace talus::messages
