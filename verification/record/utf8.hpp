#pragma once

#include <string>
#include <string_view>

namespace talus::records {

/// Whether a text is valid UTF-8, which JSON and XML require.
[[nodiscard]] bool is_utf8(std::string_view text);

/// A text of unknown encoding as UTF-8: unchanged if it is valid UTF-8, otherwise with each byte read as a character of
/// Latin-1 (ISO 8859-1).
[[nodiscard]] std::string as_utf8(std::string_view text);

}  // namespace talus::records
