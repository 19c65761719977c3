#pragma once

#include <filesystem>
#include <string>

namespace talus {

/// The text of a JSON file, which is not nested too deeply to be worked with (records::demand_shallow_json). Errors:
/// IoError with the system's reason; InputError with file and line.
[[nodiscard]] std::string read_json_text(const std::filesystem::path& file);

}  // namespace talus
