#pragma once

#include <filesystem>
#include <string>

namespace talus {

/// The text of a JSON file. Errors: IoError with the system's reason; InputError with file and line if it is nested too
/// deeply to be processed (records::demand_shallow_json).
[[nodiscard]] std::string read_json_text(const std::filesystem::path& file);

}  // namespace talus
