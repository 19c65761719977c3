#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace talus::records {

/// The names of an enumeration's values in the records. Specialised next to each enumeration, with a static array
/// `values` of (value, name) pairs.
template <class Enum>
struct Names;

template <class Enum>
concept Named = requires {
  Names<Enum>::values;
};

/// The name of `value` in the records.
template <Named Enum>
[[nodiscard]] constexpr const char* name_of(Enum value) {
  for (const auto& [each, name] : Names<Enum>::values) {
    if (each == value) return name;
  }
  throw std::logic_error("a value outside its enumeration");
}

/// The value with that name; empty if there is none.
template <Named Enum>
[[nodiscard]] constexpr std::optional<Enum> value_named(std::string_view name) {
  for (const auto& [each, text] : Names<Enum>::values) {
    if (name == text) return each;
  }
  return {};
}

/// All names, in the order of the values.
template <Named Enum>
[[nodiscard]] std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& entry : Names<Enum>::values)
    names.emplace_back(entry.second);
  return names;
}

}  // namespace talus::records
