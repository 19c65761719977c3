#pragma once

#include <string>

namespace talus::verification {

/// True if `text` contains `part`.
inline bool holds_text(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace talus::verification
