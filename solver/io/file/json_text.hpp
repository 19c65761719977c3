#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace talus {

/// The text of a JSON file. Errors: IoError with the system's reason; InputError with file and line if it is nested too
/// deeply to be processed (records::demand_shallow_json).
[[nodiscard]] std::string read_json_text(const std::filesystem::path& file);

/// The same check for JSON that begins on a line of a file. Errors: InputError with file and line.
void demand_shallow_json(std::string_view text, const std::filesystem::path& file, std::size_t line = 1);

}  // namespace talus
