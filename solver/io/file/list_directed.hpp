#pragma once

#include <string>
#include <string_view>

namespace talus {

/// A text without the byte-order mark that some editors write at its start.
inline std::string_view without_mark(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

/// Reader of Fortran's list-directed format, READ(unit,*): a record starts on a new line, continues on the next line
/// while values are missing, and ignores the rest of its last line. Values are separated by blanks, tabs or one comma;
/// `r*value` represents r equal values. Lines end with LF or CR LF.
///
/// Errors are InputError without a location, which the caller adds: for the end of the text, and for null values (two
/// consecutive commas, `r*`, a slash), for which Fortran would leave a variable unchanged.
class ListDirected {
 public:
  /// A byte-order mark at the start is skipped.
  explicit ListDirected(std::string_view text) : rest_{without_mark(text)} {}

  /// The next line as a whole: READ(unit,'(A)').
  [[nodiscard]] std::string_view whole_line();
  /// Starts the next record.
  void start_record();
  /// The next value of the record, as written.
  [[nodiscard]] std::string_view value();
  /// Number of the next line that is not blank, without reading it; 0 if there is none.
  [[nodiscard]] int next_line() const;
  /// Number of the line last read from, counted from 1.
  [[nodiscard]] int line() const { return line_; }

 private:
  bool take_line();
  void skip_separators();
  std::string_view token();

  std::string_view rest_;  ///< after the current line
  std::string_view left_;  ///< unread part of the current line
  int line_{0};
  bool comma_{true};  ///< whether a comma here would enclose a null value
  std::string_view repeated_;
  long repeats_{0};  ///< how many more times value() returns `repeated_`
};

}  // namespace talus
