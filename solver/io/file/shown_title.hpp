#pragma once

#include <filesystem>
#include <string>

namespace talus {

/// A title as headings show it: without blanks at its ends, and if nothing is left the name of its file without the
/// extension, or of its folder.
[[nodiscard]] std::string shown_title(const std::string& title, const std::filesystem::path& file);

}  // namespace talus
