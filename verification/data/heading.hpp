#pragma once

#include <string>

namespace talus::verification {

/// The heading of a column: "NAME [UNIT]", or "NAME" for pure numbers.
struct Heading {
  std::string name, unit;
};

[[nodiscard]] inline Heading heading_of(const std::string& text) {
  const std::size_t open = text.rfind(" [");
  if (open == std::string::npos || text.back() != ']') return {text, "1"};
  return {text.substr(0, open), text.substr(open + 2, text.size() - open - 3)};
}

}  // namespace talus::verification
