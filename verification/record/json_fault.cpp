#include "verification/record/json_fault.hpp"

#include <string_view>

namespace talus::records {

std::string json_fault(const std::exception& error) {
  const std::string_view text = error.what(), end = "] ";
  const std::size_t number = text.starts_with("[json.exception.") ? text.find(end) : std::string_view::npos;
  return std::string{number == std::string_view::npos ? text : text.substr(number + end.size())};
}

}  // namespace talus::records
