#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::verification::problems {

/// Cells of a row of a table, from one format in which " | " separates them: cells("{} | {:.3f}", name, error).
template <class... Values>
[[nodiscard]] std::vector<std::string> cells(fmt::format_string<Values...> format, Values&&... values) {
  const std::string text = fmt::format(format, std::forward<Values>(values)...);
  constexpr std::string_view separator = " | ";
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + separator.size()) {
    end = text.find(separator, begin);
    cells.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
  }
  return cells;
}

}  // namespace talus::verification::problems
