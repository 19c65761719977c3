#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/program/program_run.hpp"

/// Command lines whose options are checked one by one.
namespace talus::verification::problems {

/// An option of the program with its values, e.g. {"--window", {"0", "0", "1", "1"}}.
using Option = std::pair<std::string, std::vector<std::string>>;
using Options = std::vector<Option>;

/// The command with the options. The fault without_NAME leaves option --NAME out (dashes in NAME as underscores).
[[nodiscard]] std::vector<std::string> with_options(std::vector<std::string> command, const Options& options,
                                                    const Setup& setup);

/// The program in a temporary folder; faults without_NAME leave options out.
class Program {
 public:
  explicit Program(const Setup& setup) : setup_{&setup} {}

  [[nodiscard]] const Setup& setup() const { return *setup_; }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

  /// Standard output of a run that must succeed. Throws std::runtime_error.
  std::string run(const std::vector<std::string>& command, const Options& options = {}) const;
  [[nodiscard]] records::Json json(const std::vector<std::string>& command, const Options& options = {}) const;
  ProgramEnd end(const std::vector<std::string>& command, const Options& options = {}) const;

  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  [[nodiscard]] bool has(const std::string& name) const;
  /// Names, relative to the folder, of the files in a folder inside of it, sorted.
  [[nodiscard]] std::vector<std::string> files(const std::string& name) const;
  /// Text of a file of the folder; "missing NAME" if there is none.
  [[nodiscard]] std::string read(const std::string& name) const;
  /// A JSON or CSV file of the folder. Throws records::FileError.
  [[nodiscard]] records::Json file(const std::string& name) const;
  [[nodiscard]] records::Csv csv(const std::string& name) const;

 private:
  TemporaryFolder folder_;
  const Setup* setup_;
};

/// Replaces the first `old` in a text. Throws std::runtime_error if there is none.
void replace(std::string& text, const std::string& old, const std::string& with);

/// The text with single blanks in place of several.
[[nodiscard]] std::string squeezed(const std::string& text);

/// The first number after a text; NaN if the text does not occur.
[[nodiscard]] double number_after(const std::string& text, const std::string& before);

/// All numbers of a text that follow a blank, quote, bracket, comma, tab, line end or `=`.
[[nodiscard]] std::vector<double> numbers_in(std::string_view text);

/// The numbers on the same line after the first occurrence of a text. Errors: std::runtime_error without one.
[[nodiscard]] std::vector<double> numbers_on_line_after(const std::string& text, const std::string& before);

/// Counts texts, numbers and files that differ from those expected, and keeps their names.
class Differences {
 public:
  template <class T>
  void compare(const std::string& name, const T& found, const T& expected) {
    ++compared_;
    if (!(found == expected)) ++differing_[name];
  }
  void holds(const std::string& name, bool condition) { compare(name, condition, true); }
  void contains(const std::string& name, std::string_view text, std::string_view part) {
    holds(name, text.find(part) != std::string_view::npos);
  }
  /// A run must have ended with this exit status, and have this text among its messages.
  void ended(const std::string& name, const ProgramEnd& end, int exit_code, std::string_view message) {
    holds(name, end.exit_code == exit_code && end.messages.find(message) != std::string::npos);
  }

  /// Checks that there are none; a red check names them. The check fails if nothing was compared: the loop that was to
  /// compare found no items.
  void expect_none(Findings& findings, const std::string& check, const std::string& why) const;

 private:
  int compared_{};
  std::map<std::string, int> differing_;  ///< number of differences by name
};

}  // namespace talus::verification::problems
