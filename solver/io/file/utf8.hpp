#pragma once

#include <string>
#include <string_view>

namespace talus {

/// Whether a text is UTF-8, as JSON and XML demand of what is written to them.
[[nodiscard]] bool is_utf8(std::string_view text);

/// A text of unknown encoding as UTF-8: its own bytes if they are that, else each of them as a character of Latin-1
/// (ISO 8859-1).
[[nodiscard]] std::string as_utf8(std::string_view text);

}  // namespace talus
