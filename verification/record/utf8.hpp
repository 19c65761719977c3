#pragma once

#include <string>
#include <string_view>

namespace talus::records {

/// Whether a text is valid UTF-8, which JSON and XML require.
[[nodiscard]] bool is_utf8(std::string_view text);

/// A text of unknown encoding as UTF-8: unchanged if it is valid UTF-8, otherwise with each byte read as a character of
/// Latin-1 (ISO 8859-1).
[[nodiscard]] std::string as_utf8(std::string_view text);

/// A text of a file as one line for a terminal: UTF-8 (as_utf8), with its control characters, which could move the
/// cursor, hide text or look like a message, written as in TOML: `\n`, `\r`, `\x1b`. Tabs remain.
[[nodiscard]] std::string shown_text(std::string_view text);

/// The same for a text of several lines, whose ends remain.
[[nodiscard]] std::string shown_lines(std::string_view text);

}  // namespace talus::records
