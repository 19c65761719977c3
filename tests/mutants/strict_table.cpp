#include "tests/mutants/strict_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace talus::mutants {

void refuse(const toml::source_region& region, const std::string& message) {
  throw std::runtime_error(fmt::format("{}:{}: {}", region.path ? *region.path : "", region.begin.line, message));
}

toml::table parsed(const std::filesystem::path& file) {
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& fault) {
    refuse(fault.source(), std::string(fault.description()));
  }
}

std::vector<const toml::table*> tables_of(const toml::table& table, std::string_view key,
                                          std::initializer_list<std::string_view> known) {
  std::vector<const toml::table*> tables;
  const auto* const list = table[key].as_array();
  if (list == nullptr) return tables;
  for (const auto& entry : *list) {
    const auto* const each = entry.as_table();
    if (each == nullptr) refuse(entry.source(), fmt::format("{0} must be tables: [[{0}]]", key));
    for (const auto& [name, value] : *each) {
      if (std::find(known.begin(), known.end(), name.str()) == known.end())
        refuse(value.source(), fmt::format("key '{}' is not known; allowed: {}", name.str(), fmt::join(known, ", ")));
    }
    tables.push_back(each);
  }
  return tables;
}

std::string text_of(const toml::table& table, std::string_view key, bool may_be_empty) {
  const auto value = table[key].value<std::string>();
  if (!value || (value->empty() && !may_be_empty))
    refuse(table.source(), fmt::format("{} is missing; it must be a text", key));
  return *value;
}

}  // namespace talus::mutants
