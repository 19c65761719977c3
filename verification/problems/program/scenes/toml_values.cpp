#include "verification/problems/program/scenes/toml_values.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <charconv>

namespace talus::verification::problems {
namespace {

/// A text as a quantity "NUMBER UNIT", or as it is.
TomlValue toml_value(std::string key, const std::string& text) {
  double number = 0.0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto length = static_cast<std::size_t>(end - text.data());
  if (failure != std::errc{} || length >= text.size() || text[length] != ' ') return {std::move(key), {}, text};
  return {std::move(key), number, text.substr(length + 1)};
}

void add_values(const std::string& key, const toml::node& node, std::vector<TomlValue>& values) {
  if (const toml::table* const table = node.as_table()) {
    for (const auto& [name, member] : *table)
      add_values(key.empty() ? std::string{name.str()} : fmt::format("{}.{}", key, name.str()), member, values);
  } else if (const toml::array* const list = node.as_array()) {
    for (std::size_t i = 0; i < list->size(); ++i)
      add_values(fmt::format("{}[{}]", key, i), (*list)[i], values);
  } else if (const auto number = node.value<double>()) {
    values.push_back({key, *number, ""});
  } else {
    values.push_back(toml_value(key, node.value_or(std::string{})));
  }
}

}  // namespace

std::vector<TomlValue> toml_values(const std::string& text) {
  std::vector<TomlValue> values;
  add_values("", toml::parse(text), values);
  return values;
}

}  // namespace talus::verification::problems
