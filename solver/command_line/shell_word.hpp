#pragma once

#include <string>

namespace talus {

/// The text in single quotes, as sh, bash and zsh read it.
[[nodiscard]] std::string single_quoted(const std::string& text);

/// A word of a printed command, quoted for a shell if it contains characters other than letters, digits, bytes of UTF-8
/// and `/ . _ - + , : = @ %`.
[[nodiscard]] std::string shell_word(const std::string& word);

}  // namespace talus
