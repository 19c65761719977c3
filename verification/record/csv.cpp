#include "verification/record/csv.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "verification/record/error.hpp"
#include "verification/record/utf8.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::records {
namespace {

/// Splits a text into cells.
class Splitter {
 public:
  Splitter(const std::filesystem::path& file, std::string_view text, std::vector<char>& cells)
      : file_{file}, text_{text}, cells_{cells} {
    cells_.reserve(text.size());  // no reallocation: the cells have fewer characters than the text
  }

  /// Line of the next character, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }

  /// Moves to the next line with cells; false if there is none.
  bool find_row() {
    while (offset_ < text_.size()) {
      if (text_[offset_] != '\n' && text_[offset_] != '#' && text_.compare(offset_, 2, "\r\n") != 0) return true;
      const std::size_t end = text_.find('\n', offset_);
      if (end == std::string_view::npos) return false;
      offset_ = end + 1;
      ++line_;
    }
    return false;
  }

  /// The next cell of the row; sets `last` if the row ends with it.
  std::string_view next_cell(bool& last) {
    const char* const begin = cells_.data() + cells_.size();
    const std::size_t size = cells_.size();
    if (offset_ < text_.size() && text_[offset_] == '"') take_quoted();
    // Text after a closing quote belongs to the cell, up to the next comma.
    while (offset_ < text_.size() && text_[offset_] != ',' && text_[offset_] != '\n') {
      if (text_.compare(offset_, 2, "\r\n") != 0) cells_.push_back(text_[offset_]);
      ++offset_;
    }
    if (offset_ == text_.size()) {
      throw RecordError(fmt::format("{}:{}: the last line has no end; the file was cut short", file_.string(), line_));
    }
    last = text_[offset_++] == '\n';
    line_ += last ? 1 : 0;
    return {begin, cells_.size() - size};
  }

 private:
  void take_quoted() {
    const std::size_t first = line_;
    for (++offset_; offset_ < text_.size(); ++offset_) {
      if (text_[offset_] == '"') {
        ++offset_;
        if (offset_ == text_.size() || text_[offset_] != '"') return;
      }
      line_ += text_[offset_] == '\n' ? 1 : 0;
      cells_.push_back(text_[offset_]);
    }
    throw RecordError(fmt::format("{}:{}: a quoted cell that begins here does not end", file_.string(), first));
  }

  const std::filesystem::path& file_;
  std::string_view text_;
  std::vector<char>& cells_;
  std::size_t offset_ = 0;
  std::size_t line_ = 1;
};

}  // namespace

Csv::Csv(std::filesystem::path file, std::string_view text) : file_{std::move(file)} {
  // Some programs begin a file with this mark of UTF-8.
  if (constexpr std::string_view mark = "\xEF\xBB\xBF"; text.starts_with(mark)) text.remove_prefix(mark.size());
  Splitter splitter{file_, text, text_};
  if (!splitter.find_row()) {
    throw RecordError(fmt::format("{}: found no header; the first line must name the columns", file_.string()));
  }
  // A comment may be in another encoding.
  const bool all_utf8 = is_utf8(text);
  const auto next_cell = [&](bool& last) {
    const std::size_t line = splitter.line();
    const std::string_view cell = splitter.next_cell(last);
    if (!all_utf8 && !is_utf8(cell))
      throw RecordError(fmt::format("{}:{}: found \"{}\", which is not UTF-8; save the file as UTF-8", file_.string(),
                                    line, as_utf8(cell)));
    return cell;
  };
  const std::size_t header_line = splitter.line();
  for (bool last = false; !last;)
    header_.emplace_back(next_cell(last));
  if (header_.size() == 1 && header_.front().find(';') != std::string::npos) {
    throw RecordError(
        fmt::format("{}:{}: found the header \"{}\"; cells must be separated by commas, with points in numbers",
                    file_.string(), header_line, header_.front()));
  }
  while (splitter.find_row()) {
    lines_.push_back(splitter.line());
    const std::size_t before = cells_.size();
    for (bool last = false; !last;)
      cells_.push_back(next_cell(last));
    if (const std::size_t found = cells_.size() - before; found != header_.size()) {
      throw RecordError(fmt::format("{}:{}: found {} cells; the header has {}", file_.string(), lines_.back(), found,
                                    header_.size()));
    }
  }
}

std::size_t Csv::column(std::string_view name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  if (found == header_.end()) {
    throw RecordError(
        fmt::format("{}: has no column '{}'; its columns: {}", file_.string(), name, fmt::join(header_, ", ")));
  }
  if (std::find(found + 1, header_.end(), name) != header_.end())
    throw RecordError(fmt::format("{}: found two columns '{}'; give them different names", file_.string(), name));
  return static_cast<std::size_t>(found - header_.begin());
}

double Csv::number(std::size_t row, std::size_t column) const {
  const std::string_view text = cell(row, column);
  double value = 0.0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw RecordError(fmt::format("{}:{}: column '{}': found '{}'; it must be a finite number", file_.string(),
                                  lines_[row], shown_text(header_[column]), shown_text(text)));
  }
  return value;
}

Csv read_csv(const std::filesystem::path& file) { return {file, read_whole(file)}; }

CsvText::CsvText(const std::vector<std::string>& columns) : columns_{columns.size()} {
  for (const std::string& name : columns)
    cell(name);
  end_row();
}

void CsvText::separate() {
  if (cells_++ > 0) text_ += ',';
}

void CsvText::cell(std::string_view text) {
  separate();
  // Otherwise a line that begins with # would be skipped when read, and so would an empty line.
  const bool first = cells_ == 1;
  const bool passed_over = first && (text.empty() ? columns_ == 1 : text.front() == '#');
  if (!passed_over && text.find_first_of(",\"\n\r") == std::string_view::npos) {
    text_ += text;
    return;
  }
  text_ += '"';
  for (const char letter : text) {
    if (letter == '"') text_ += '"';
    text_ += letter;
  }
  text_ += '"';
}

void CsvText::number(double value) {
  separate();
  fmt::format_to(std::back_inserter(text_), FMT_COMPILE("{}"), value);
}

void CsvText::number(double value, int digits) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{:.{}g}", value, digits);
}

void CsvText::end_row() {
  if (cells_ != columns_) {
    throw std::logic_error(fmt::format("a row of {} cells under a header of {} columns", cells_, columns_));
  }
  text_ += '\n';
  cells_ = 0;
}

}  // namespace talus::records
