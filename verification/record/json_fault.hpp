#pragma once

#include <exception>
#include <string>

namespace talus::records {

/// The text of an error of the JSON library without the number that it begins with: "key 'id' not found" of
/// "[json.exception.out_of_range.403] key 'id' not found".
[[nodiscard]] std::string json_fault(const std::exception& error);

}  // namespace talus::records
