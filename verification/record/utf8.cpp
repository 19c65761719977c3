#include "verification/record/utf8.hpp"

#include <fmt/format.h>

namespace talus::records {
namespace {

/// Length of the UTF-8 sequence at the start of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const bool overlong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xf0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xed && byte(1) >= 0xa0;
  const bool beyond = lead == 0xf4 && byte(1) >= 0x90;
  return overlong || surrogate || beyond ? 0 : length;
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string as_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string{text};
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x80) result += static_cast<char>(0xc0 | (code >> 6));
    result += code < 0x80 ? c : static_cast<char>(0x80 | (code & 0x3f));
  }
  return result;
}

namespace {

/// Escapes all control characters but the unchanged ones.
std::string without_controls(std::string_view text, std::string_view unchanged) {
  std::string result;
  const std::string letters = as_utf8(text);
  for (std::size_t i = 0; i < letters.size(); ++i) {
    auto code = static_cast<unsigned char>(letters[i]);
    // U+0080 .. U+009F are control characters in two bytes; U+009B begins the same commands as the escape character.
    const bool upper = code == 0xc2 && static_cast<unsigned char>(letters[i + 1]) < 0xa0;
    const bool control = upper || code < 0x20 || code == 0x7f;
    if (!control || unchanged.find(letters[i]) != std::string_view::npos) {
      result += letters[i];
      continue;
    }
    if (upper) code = static_cast<unsigned char>(letters[++i]);
    result += code == '\n' ? "\\n" : code == '\r' ? "\\r" : fmt::format("\\x{:02x}", code);
  }
  return result;
}

}  // namespace

std::string shown_text(std::string_view text) { return without_controls(text, "\t"); }

std::string shown_lines(std::string_view text) { return without_controls(text, "\t\n"); }

}  // namespace talus::records
