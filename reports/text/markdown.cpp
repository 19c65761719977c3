#include "reports/text/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace talus::reports::markdown {
namespace {

bool blank(char letter) { return std::isspace(static_cast<unsigned char>(letter)) != 0; }

/// Length of the `$maths$` or `` `code` `` span that starts at `offset`, by pandoc's rules; 0 if none does.
std::size_t span_length(const std::string& text, std::size_t offset) {
  const char mark = text[offset];
  if (mark != '$' && mark != '`') return 0;
  const std::size_t end = text.find(mark, offset + 1);
  if (end == std::string::npos || end == offset + 1) return 0;
  if (mark == '`') return end + 1 - offset;
  if (blank(text[offset + 1]) || blank(text[end - 1])) return 0;
  if (end + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[end + 1])) != 0) return 0;
  return end + 1 - offset;
}

bool is_mark(char letter) { return std::string("\\`*_{}[]<>#|$~^@\"'").find(letter) != std::string::npos; }

std::string escaped(const std::string& text, bool in_cell) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (const std::size_t length = span_length(text, i); length > 0) {
      for (const char letter : text.substr(i, length)) {
        // A bar would end the cell; in maths \vert prints the same character.
        if (letter == '|' && in_cell) {
          result += text[i] == '$' ? "\\vert " : "\\|";
        } else {
          result += letter == '\n' ? ' ' : letter;
        }
      }
      i += length - 1;
    } else if (blank(text[i])) {
      if (!result.empty() && result.back() != ' ') result += ' ';
    } else {
      if (is_mark(text[i])) result += '\\';
      // Smart typography would change three points and two dashes, the block rules a list mark at the start.
      if ((text[i] == '.' || text[i] == '-') && i + 1 < text.size() && text[i + 1] == text[i]) result += '\\';
      if (result.empty() && (text[i] == '-' || text[i] == '+' || text[i] == ':')) result += '\\';
      result += text[i];
    }
  }
  while (!result.empty() && result.back() == ' ')
    result.pop_back();
  return result;
}

/// Visible text of a cell: links without their targets, marks without their escapes.
std::string visible(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "](") == 0) {
      i = std::min(text.find(')', i), text.size() - 1);
    } else if (text[i] != '\\' && text[i] != '[') {
      result += text[i];
    }
  }
  return result;
}

/// Length in characters, not bytes: continuation bytes of UTF-8 do not count.
std::size_t length_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::size_t longest_word(const std::string& text) {
  std::istringstream stream(text);
  std::string word;
  std::size_t longest = 0;
  while (stream >> word)
    longest = std::max(longest, length_of(word));
  return longest;
}

/// Dashes for each column: room for its longest word, and a fraction of the remaining width by the length of its
/// longest cells.
std::vector<std::size_t> widths_of(const std::vector<Column>& columns,
                                   const std::vector<std::vector<std::string>>& rows) {
  constexpr std::size_t whole = 112;
  std::vector<std::size_t> minimum(columns.size());
  std::vector<std::size_t> wish(columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    minimum[c] = std::max<std::size_t>(longest_word(columns[c].heading), 3);
    wish[c] = length_of(columns[c].heading);
    for (const auto& row : rows) {
      minimum[c] = std::max(minimum[c], std::min<std::size_t>(longest_word(visible(row[c])), 30));
      wish[c] = std::max(wish[c], length_of(visible(row[c])));
    }
    wish[c] = std::max(wish[c], minimum[c]) - minimum[c];
    ++minimum[c];
  }
  std::size_t taken = 0;
  double wished = 0.0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    taken += minimum[c];
    wished += static_cast<double>(wish[c]);
  }
  const double spare = taken < whole ? static_cast<double>(whole - taken) : 0.0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    // Spare width is used only as required: a small table stays small.
    const double ratio = wished > spare ? spare / wished : 1.0;
    minimum[c] += static_cast<std::size_t>(ratio * static_cast<double>(wish[c]));
  }
  return minimum;
}

}  // namespace

std::string text(const std::string& text) { return escaped(text, false); }

std::string cell(const std::string& text) { return escaped(text, true); }

std::string code(const std::string& text) {
  const std::string fence = text.find('`') == std::string::npos ? "`" : "``";
  return fence + (fence.size() > 1 ? " " + text + " " : text) + fence;
}

std::string heading_id(const std::string& heading) {
  std::string id;
  for (const char letter : heading) {
    const auto byte = static_cast<unsigned char>(letter);
    if (letter == ' ') {
      id += '-';
    } else if (std::isalnum(byte) != 0 || letter == '-' || letter == '_' || byte >= 0x80) {
      id += static_cast<char>(std::tolower(byte));
    }
  }
  return id;
}

std::string with_headings_below(const std::string& text, int level) {
  const auto visit_lines = [&](auto&& visit) {
    std::istringstream stream(text);
    std::string line;
    std::string result;
    bool fenced = false;
    while (std::getline(stream, line)) {
      const bool fence = line.rfind("```", 0) == 0 || line.rfind("~~~", 0) == 0;
      if (fence) fenced = !fenced;
      const std::size_t marks = line.find_first_not_of('#');
      const bool heading = !fenced && !fence && marks != std::string::npos && marks > 0 && line[marks] == ' ';
      result += visit(line, heading ? static_cast<int>(marks) : 0) + "\n";
    }
    return result;
  };
  int highest = 7;
  visit_lines([&](const std::string& line, int marks) {
    if (marks > 0) highest = std::min(highest, marks);
    return line;
  });
  return visit_lines([&](const std::string& line, int marks) {
    if (marks == 0) return line;
    const int moved = std::clamp(marks + level - highest, 1, 6);
    return std::string(static_cast<std::size_t>(moved), '#') + line.substr(static_cast<std::size_t>(marks));
  });
}

std::string table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows,
                  const std::string& caption) {
  const std::vector<std::size_t> widths = widths_of(columns, rows);
  std::string text = "|";
  std::string rule = "|";
  for (std::size_t c = 0; c < columns.size(); ++c) {
    text += " " + columns[c].heading + " |";
    const std::string dashes(widths[c], '-');
    rule += columns[c].numbers ? fmt::format("{}:|", dashes) : fmt::format(":{}|", dashes);
  }
  text += "\n" + rule + "\n";
  for (const auto& row : rows) {
    text += "|";
    for (const std::string& entry : row)
      text += " " + (entry.empty() ? std::string("–") : entry) + " |";
    text += "\n";
  }
  return caption.empty() ? text : text + "\nTable: " + caption + "\n";
}

std::string number(double value, int digits) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  return fmt::format("{:.{}g}", value == 0.0 ? 0.0 : value, digits);
}

int digits_to_tell(double measured, double reference) {
  const double size = std::max(std::abs(measured), std::abs(reference));
  const double difference = std::abs(measured - reference);
  if (!std::isfinite(size) || !(size > 0.0)) return 5;
  if (!(difference > 0.0)) return 6;
  return std::clamp(static_cast<int>(std::ceil(std::log10(size / difference))) + 2, 5, 12);
}

}  // namespace talus::reports::markdown
