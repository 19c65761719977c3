#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace talus::records {

/// Largest nesting depth of lists and objects in JSON that is read; no file of Talus has more than ten.
inline constexpr std::size_t deepest_json = 64;

/// Rejects a JSON text that is nested deeper: copying, comparing and printing a value recurse for each level and would
/// overflow the stack. RecordError with the file and the line, counted from that of the beginning of the text. It does
/// not check that the text is JSON.
void demand_shallow_json(std::string_view text, const std::filesystem::path& file, std::size_t line = 1);

}  // namespace talus::records
