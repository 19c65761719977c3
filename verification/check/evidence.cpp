#include "verification/check/evidence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "verification/check/paragraph.hpp"

namespace talus::verification {

namespace {

constexpr std::string_view remark = "Not shown: ";

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

}  // namespace

EvidenceParagraph evidence_of(std::string_view page) {
  EvidenceParagraph result;
  std::string text = paragraph_of(page, "Evidence");
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
    const std::optional<Evidence> kind = records::value_named<Evidence>(name);
    if (!kind) {
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
  return fmt::format("**Evidence.** {}. {}{}\n", names, remark, paragraph.not_shown);
}

}  // namespace talus::verification
