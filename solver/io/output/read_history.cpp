#include "solver/io/output/read_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "solver/base/error.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus {
namespace {

/// Takes the text up to the mark from the front of `rest`, the mark too.
std::string_view taken(std::string_view& rest, char mark) {
  const std::size_t end = std::min(rest.find(mark), rest.size());
  const std::string_view part = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return part;
}

KeptColumn column(std::string_view header) {
  const std::size_t bracket = header.rfind(" [");
  if (bracket == std::string_view::npos || header.back() != ']') return {std::string{header}, "", {}};
  return {
      std::string{header.substr(0, bracket)}, std::string{header.substr(bracket + 2, header.size() - bracket - 3)}, {}};
}

double number(std::string_view cell, const std::string& place) {
  double value = 0.0;
  const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (failure != std::errc{} || end != cell.data() + cell.size()) {
    throw InputError{fmt::format("{}: found \"{}\"; it must be a number", place, cell)};
  }
  return value;
}

}  // namespace

std::string KeptColumn::subject() const {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(0, dot);
}

std::string KeptColumn::quantity() const {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? name : name.substr(dot + 1);
}

const KeptColumn* KeptHistory::find(const std::string& name) const {
  const auto place =
      std::find_if(columns.begin(), columns.end(), [&](const KeptColumn& each) { return each.name == name; });
  return place == columns.end() ? nullptr : &*place;
}

KeptHistory read_history(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  KeptHistory history{file, {}};
  std::string_view rest{text};
  for (int line = 1; !rest.empty(); ++line) {
    std::string_view row = taken(rest, '\n');
    if (row.empty() || row.front() == '#') continue;
    if (history.columns.empty()) {
      while (!row.empty())
        history.columns.push_back(column(taken(row, ',')));
      continue;
    }
    const auto cells = static_cast<std::size_t>(std::count(row.begin(), row.end(), ',')) + 1;
    if (cells != history.columns.size()) {
      throw InputError{fmt::format("{}:{}: found {} numbers; its head has {} columns", file.string(), line, cells,
                                   history.columns.size())};
    }
    for (KeptColumn& each : history.columns)
      each.values.push_back(number(taken(row, ','), fmt::format("{}:{}: {}", file.string(), line, each.name)));
  }
  if (history.columns.empty())
    throw InputError{fmt::format("{}: found no head; it must name the columns", file.string())};
  return history;
}

}  // namespace talus
