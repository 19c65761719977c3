#include "solver/command_line/shell_word.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace talus {

std::string single_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? "'\\''" : std::string{c};
  return quoted + "'";
}

std::string shell_word(const std::string& word) {
  const auto is_plain = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::isalnum(byte) != 0 || std::string_view{"/._-+,:=@%"}.find(c) != std::string_view::npos;
  };
  return !word.empty() && std::all_of(word.begin(), word.end(), is_plain) ? word : single_quoted(word);
}

}  // namespace talus
