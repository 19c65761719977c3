#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace talus::records {

/// Nesting of lists and objects up to which JSON is read; no file of Talus has more than ten.
inline constexpr std::size_t deepest_json = 64;

/// Refuses a JSON text that is nested deeper: copying, comparing and printing a value call themselves for each level,
/// and would overflow the stack. RecordError with the file and the line; whether the text is JSON is not checked.
void demand_shallow_json(std::string_view text, const std::filesystem::path& file);

}  // namespace talus::records
