#include "verification/check/evidence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace talus::verification {

namespace {

constexpr std::string_view label = "**Evidence.** ", remark = "Not shown: ";

/// The paragraph behind its label on one line; empty if the page has none.
std::string paragraph_in(std::string_view page) {
  std::size_t at = page.find(label);
  if (at == std::string_view::npos || (at > 0 && page[at - 1] != '\n')) return "";
  at += label.size();
  std::string paragraph{page.substr(at, page.find("\n\n", at) - at)};
  while (!paragraph.empty() && paragraph.back() == '\n')
    paragraph.pop_back();
  std::replace(paragraph.begin(), paragraph.end(), '\n', ' ');
  return paragraph;
}

/// Markdown as plain text: without the backslashes before punctuation, except in formulas.
std::string plain(std::string_view markdown) {
  std::string text;
  bool formula = false;
  for (std::size_t i = 0; i < markdown.size(); ++i) {
    const bool escapes = !formula && markdown[i] == '\\' && i + 1 < markdown.size() &&
                         std::ispunct(static_cast<unsigned char>(markdown[i + 1])) != 0;
    if (escapes) ++i;
    if (!escapes && markdown[i] == '$') formula = !formula;
    text += markdown[i];
  }
  return text;
}

const Evidence* kind_called(const std::string& name) {
  for (const auto& [kind, known] : records::Names<Evidence>::values) {
    if (name == known) return &kind;
  }
  return nullptr;
}

}  // namespace

EvidenceParagraph evidence_of(std::string_view page) {
  EvidenceParagraph result;
  std::string text = paragraph_in(page);
  if (text.empty()) {
    result.error = "it has no paragraph **Evidence.**";
    return result;
  }
  text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  const std::size_t end = text.find('.');
  std::string names = text.substr(0, end);
  for (std::size_t at = 0; at != std::string::npos;) {
    const std::size_t comma = names.find(", ", at);
    const std::string name = names.substr(at, comma == std::string::npos ? comma : comma - at);
    at = comma == std::string::npos ? comma : comma + 2;
    const Evidence* const kind = kind_called(name);
    if (kind == nullptr) {
      result.error = fmt::format("its evidence '{}' is not known; known: {}", name,
                                 fmt::join(records::all_names<Evidence>(), ", "));
      return result;
    }
    if (!result.kinds.empty() && *kind <= result.kinds.back()) {
      result.error = fmt::format("its evidence '{}' is behind '{}'; the order must be: {}", name,
                                 name_of(result.kinds.back()), fmt::join(records::all_names<Evidence>(), ", "));
      return result;
    }
    result.kinds.push_back(*kind);
  }
  const std::string rest = end == std::string::npos || end + 2 > text.size() ? "" : text.substr(end + 2);
  if (!rest.starts_with(remark) || rest.size() == remark.size() || rest.back() != '.') {
    result.error = fmt::format("its evidence is followed by '{}'; it must be 'Not shown: ' and a sentence", rest);
    return result;
  }
  result.not_shown = plain(rest).substr(remark.size());
  return result;
}

std::string text_of(const EvidenceParagraph& paragraph) {
  std::string names;
  for (const Evidence kind : paragraph.kinds)
    names += (names.empty() ? "" : ", ") + std::string{name_of(kind)};
  if (!names.empty()) names.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(names.front())));
  return fmt::format("{}{}. {}{}\n", label, names, remark, paragraph.not_shown);
}

}  // namespace talus::verification
