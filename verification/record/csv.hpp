#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::records {

/// A CSV file: a header with the column names, then one line for each row. As in RFC 4180 a cell in double quotes may
/// contain commas, line ends and doubled quotes; lines may end with CR LF. Empty lines and lines that begin with `#`
/// are skipped.
class Csv {
 public:
  /// Parses the text of a file; the file name is used only in messages. RecordError (file, line, found, allowed) if
  /// there is no header, a row has another number of cells, a quoted cell is not closed, a cell is not UTF-8, or the
  /// last line has no line end (truncated file).
  Csv(std::filesystem::path file, std::string_view text);
  Csv(const Csv&) = delete;
  Csv& operator=(const Csv&) = delete;
  Csv(Csv&&) = default;
  Csv& operator=(Csv&&) = default;

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }
  [[nodiscard]] std::size_t rows() const { return lines_.size(); }

  /// Index of the column with that name; RecordError if there is none, or two.
  [[nodiscard]] std::size_t column(std::string_view name) const;

  /// Line of the file in which a row begins, counted from 1.
  [[nodiscard]] std::size_t line(std::size_t row) const { return lines_[row]; }

  [[nodiscard]] std::string_view cell(std::size_t row, std::size_t column) const {
    return cells_[row * header_.size() + column];
  }
  [[nodiscard]] std::string_view cell(std::size_t row, std::string_view name) const { return cell(row, column(name)); }
  /// The number in a cell; RecordError if the cell contains anything else or a number that is not finite.
  [[nodiscard]] double number(std::size_t row, std::size_t column) const;
  [[nodiscard]] double number(std::size_t row, std::string_view name) const { return number(row, column(name)); }

 private:
  std::filesystem::path file_;
  std::vector<char> text_;  ///< Cells without their quotes; a vector, not a string, so that `cells_` stays valid when
                            ///< it is moved.
  std::vector<std::string> header_;
  std::vector<std::string_view> cells_;  ///< Row by row.
  std::vector<std::size_t> lines_;
};

/// Reads a CSV file. FileError if it cannot be read; RecordError as above.
[[nodiscard]] Csv read_csv(const std::filesystem::path& file);

/// Builds the text of a CSV file cell by cell. Cells are quoted where necessary.
class CsvText {
 public:
  explicit CsvText(const std::vector<std::string>& columns);

  void cell(std::string_view text);
  /// Writes the fewest digits from which the same double is read back.
  void number(double value);
  /// Writes `digits` significant digits without trailing zeros; 17 are enough to read the same double back.
  void number(double value, int digits);
  /// std::logic_error if the row has another number of cells than the header.
  void end_row();

  [[nodiscard]] std::string text() && { return std::move(text_); }

 private:
  void separate();

  std::string text_;
  std::size_t columns_;
  std::size_t cells_ = 0;  ///< Cells of the current row so far.
};

}  // namespace talus::records
