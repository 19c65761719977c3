#include "verification/check/paragraph.hpp"

#include <algorithm>

namespace talus::verification {

std::string paragraph_of(std::string_view page, std::string_view label) {
  const std::string begin = "**" + std::string{label} + ".** ";
  std::size_t at = page.starts_with(begin) ? 0 : page.find("\n" + begin);
  if (at == std::string_view::npos) return "";
  at = page.find(begin, at) + begin.size();
  std::string paragraph{page.substr(at, page.find("\n\n", at) - at)};
  while (!paragraph.empty() && paragraph.back() == '\n')
    paragraph.pop_back();
  std::replace(paragraph.begin(), paragraph.end(), '\n', ' ');
  return paragraph;
}

}  // namespace talus::verification
