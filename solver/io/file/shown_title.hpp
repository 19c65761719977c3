#pragma once

#include <filesystem>
#include <string>

namespace talus {

/// A title as shown in headings: one line, without blanks at its ends, control characters escaped; if it is blank, the
/// name of its file without the extension, or of its folder.
[[nodiscard]] std::string shown_title(const std::string& title, const std::filesystem::path& file);

}  // namespace talus
