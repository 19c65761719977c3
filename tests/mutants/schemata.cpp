#include "tests/mutants/schemata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace talus::mutants {

namespace {

constexpr std::string_view call = "talus::mutants::on(";

/// Order of edits: outer edits before those inside them; edits of the same position by number.
bool comes_before(const Switched& a, const Switched& b) {
  if (a.edit.begin != b.edit.begin) return a.edit.begin < b.edit.begin;
  if (a.edit.end != b.edit.end) return a.edit.end > b.edit.end;
  return a.number < b.number;
}

bool same_position(const Edit& a, const Edit& b) { return a.begin == b.begin && a.end == b.end && a.form == b.form; }

/// `inner`: the text at this position without these mutants.
std::string switched(std::span<const Switched> here, const std::string& inner) {
  std::string text;
  if (here.front().edit.form == Form::expression) {
    text = "(";
    for (const Switched& one : here)
      text += fmt::format("{}{}) ? ({}) : ", call, one.number, one.edit.replacement);
    return text + "(" + inner + "))";
  }
  text = "{ ";
  for (const Switched& one : here)
    text += fmt::format("if ({}{})) {{ {} }} else ", call, one.number, one.edit.replacement);
  return text + "{ " + inner + " } }";
}

std::string written(std::string_view text, std::size_t begin, std::size_t end, std::span<const Switched> edits) {
  std::string result;
  std::size_t at = begin;
  while (!edits.empty()) {
    const Edit& first = edits.front().edit;
    const auto same = std::find_if_not(edits.begin(), edits.end(),
                                       [&](const Switched& other) { return same_position(first, other.edit); });
    const auto inside =
        std::find_if_not(same, edits.end(), [&](const Switched& other) { return other.edit.begin < first.end; });
    if (std::any_of(same, inside, [&](const Switched& other) { return other.edit.end > first.end; }))
      throw std::invalid_argument(fmt::format("{}: two edits cross each other at byte {}", first.file, first.begin));
    result += text.substr(at, first.begin - at);
    result += switched({edits.begin(), same}, written(text, first.begin, first.end, {same, inside}));
    at = first.end;
    edits = {inside, edits.end()};
  }
  return result + std::string(text.substr(at, end - at));
}

}  // namespace

std::string with_switches(std::string_view text, std::span<const Switched> edits) {
  if (edits.empty()) return std::string(text);
  std::vector<Switched> sorted(edits.begin(), edits.end());
  std::sort(sorted.begin(), sorted.end(), comes_before);
  return written(text, 0, text.size(), sorted);
}

int switch_at(std::string_view text, std::size_t line, std::size_t column) {
  std::size_t start = 0;
  for (std::size_t i = 1; i < line && start != std::string_view::npos; ++i)
    start = text.find('\n', start) + 1;
  const std::size_t end = std::min(text.find('\n', start), text.size());
  const std::string_view row = text.substr(start, end - start);
  const std::size_t found = row.rfind(call, std::min(column - 1, row.size()));
  return found == std::string_view::npos ? 0 : std::atoi(row.data() + found + call.size());
}

}  // namespace talus::mutants
