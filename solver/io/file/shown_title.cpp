#include "solver/io/file/shown_title.hpp"

#include <string_view>

#include "verification/record/utf8.hpp"

namespace talus {

std::string shown_title(const std::string& title, const std::filesystem::path& file) {
  constexpr const char* blanks = " \t\r\n";
  const std::size_t first = title.find_first_not_of(blanks);
  if (first != std::string::npos)
    return records::shown_text(std::string_view{title}.substr(first, title.find_last_not_of(blanks) + 1 - first));
  const std::filesystem::path path = file.lexically_normal();
  return records::shown_text((path.has_filename() ? path : path.parent_path()).stem().string());
}

}  // namespace talus
