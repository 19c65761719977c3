#include "verification/record/json_depth.hpp"

#include <fmt/format.h>

#include "verification/record/error.hpp"

namespace talus::records {

void demand_shallow_json(std::string_view text, const std::filesystem::path& file, std::size_t line) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++line;
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest_json)
        throw RecordError{
            fmt::format("{}: line {}: found lists and objects nested deeper than {} levels, which no file of "
                        "Talus is",
                        file.string(), line, deepest_json)};
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
}

}  // namespace talus::records
