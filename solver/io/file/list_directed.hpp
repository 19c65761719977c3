#pragma once

#include <string>
#include <string_view>

namespace talus {

/// A text without the byte-order mark that editors put in front.
inline std::string_view without_mark(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

/// Text read as Fortran reads it under list-directed format, READ(unit,*): a record starts on a new line, goes on with
/// the next line where values are missing, and drops what its last line holds beyond them. Values are separated by
/// blanks, tabs or one comma; `r*value` stands for r equal values. Lines end with LF or CR LF.
///
/// Errors are InputError without a place, which the caller knows: the end of the text, and null values (two commas in a
/// row, `r*`, a slash), which Fortran would leave as they were before.
class ListDirected {
 public:
  /// A byte-order mark in front is passed over.
  explicit ListDirected(std::string_view text) : rest_{without_mark(text)} {}

  /// The next line as a whole: READ(unit,'(A)').
  [[nodiscard]] std::string_view whole_line();
  /// Starts the next record.
  void start_record();
  /// The next value of the record, as written.
  [[nodiscard]] std::string_view value();
  /// The next line that holds anything, which stays to be read; 0 if there is none.
  [[nodiscard]] int next_line() const;
  /// The line last read from, counted from 1.
  [[nodiscard]] int line() const { return line_; }

 private:
  bool take_line();
  void skip_separators();
  std::string_view token();

  std::string_view rest_;  ///< after the present line
  std::string_view left_;  ///< of the present line
  int line_{0};
  bool comma_{true};  ///< whether a comma here would enclose a null value
  std::string_view repeated_;
  long repeats_{0};  ///< how often `repeated_` is still to be given
};

}  // namespace talus
