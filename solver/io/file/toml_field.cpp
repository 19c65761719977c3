#include "solver/io/file/toml_field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "solver/base/error.hpp"

namespace talus {
namespace {

FieldKey field_key(std::string_view part, std::string_view path) {
  const auto refuse = [&] {
    throw InputError{fmt::format("found '{}'; it must be a path such as run.step or body.NAME.velocity[0]", path)};
  };
  FieldKey made{std::string{part}, {}};
  if (const std::size_t open = part.find('['); open != std::string_view::npos) {
    std::size_t index = 0;
    const char* const end = part.data() + part.size() - 1;
    const auto [read, failure] = std::from_chars(part.data() + open + 1, end, index);
    if (*end != ']' || read != end || failure != std::errc{}) refuse();
    made = {std::string{part.substr(0, open)}, index};
  }
  if (made.key.empty()) refuse();
  return made;
}

TomlEntry* entry_of(TomlTable& table, std::string_view key) {
  const auto found = std::ranges::find(table, key, &TomlEntry::key);
  return found == table.end() ? nullptr : &*found;
}

std::vector<std::string> keys_of(const TomlTable& table) {
  std::vector<std::string> keys;
  for (const TomlEntry& entry : table)
    keys.push_back(entry.key);
  return keys;
}

/// Tables that a file may leave out with all their fields.
constexpr std::array<std::string_view, 2> optional_tables{"options", "watch"};

/// The table of the list `key` that has this name.
TomlValue& named(TomlArray& list, const std::string& key, const std::string& name, std::string_view path) {
  std::vector<std::string> names;
  for (TomlValue& element : list) {
    TomlTable* const table = std::get_if<TomlTable>(&element.data);
    if (table == nullptr) continue;
    const TomlEntry* const entry = entry_of(*table, "name");
    const std::string* const text = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value.data);
    if (text == nullptr) continue;
    names.push_back(*text);
    if (*text == name) return element;
  }
  if (names.empty())
    throw InputError{fmt::format("'{0}': '{1}' is a list without names; give an index, {1}[0]", path, key)};
  throw InputError{fmt::format("'{}': {}", path, unknown_name("name", name, names).what())};
}

TomlValue& element_of(TomlValue& value, const FieldKey& key, std::string_view path) {
  TomlArray* const list = std::get_if<TomlArray>(&value.data);
  if (list == nullptr)
    throw InputError{fmt::format("'{}': '{}' is not an array; give it without [{}]", path, key.key, *key.index)};
  if (*key.index >= list->size())
    throw InputError{fmt::format("'{}': '{}' has no element [{}]; give one of its {} elements, from [0] on", path,
                                 key.key, *key.index, list->size())};
  return (*list)[*key.index];
}

}  // namespace

std::vector<FieldKey> field_keys(std::string_view path) {
  std::vector<FieldKey> keys;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t dot = std::min(path.find('.', from), path.size());
    keys.push_back(field_key(path.substr(from, dot - from), path));
    from = dot + 1;
  }
  return keys;
}

TomlValue& field_at(TomlValue& document, std::string_view path) {
  const std::vector<FieldKey> keys = field_keys(path);
  TomlValue* at = &document;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const FieldKey& key = keys[i];
    const bool is_last = i + 1 == keys.size();
    if (TomlArray* const list = std::get_if<TomlArray>(&at->data)) {
      at = &named(*list, keys[i - 1].key, key.key, path);
      if (is_last || key.index) throw InputError{fmt::format("'{}': it must end with a field of '{}'", path, key.key)};
      continue;
    }
    TomlTable* const table = std::get_if<TomlTable>(&at->data);
    if (table == nullptr)
      throw InputError{
          fmt::format("'{}': nothing can be below '{}', which is a value; give a shorter path", path, keys[i - 1].key)};
    TomlEntry* const entry = entry_of(*table, key.key);
    if (entry == nullptr) {
      if (!is_last && !key.index && std::ranges::find(optional_tables, key.key) != optional_tables.end()) {
        table->push_back({key.key, {TomlTable{}, at->line}});
        at = &table->back().value;
        continue;
      }
      if (!is_last)
        throw InputError{fmt::format("'{}': {}", path, unknown_name("field", key.key, keys_of(*table)).what())};
      if (key.index)
        throw InputError{
            fmt::format("'{}': the base has no '{}', of which an element could be set; write it there; nearest: {}; "
                        "known: {}",
                        path, key.key, nearest_name(key.key, keys_of(*table)), fmt::join(keys_of(*table), ", "))};
      table->push_back({key.key, {std::string{}, at->line}});
      return table->back().value;
    }
    at = key.index ? &element_of(entry->value, key, path) : &entry->value;
  }
  const bool is_table = std::holds_alternative<TomlTable>(at->data);
  if (is_table || std::holds_alternative<TomlArray>(at->data))
    throw InputError{fmt::format("'{}': found {}; it must be a value", path, is_table ? "a table" : "an array")};
  return *at;
}

void set_field(TomlValue& document, std::string_view path, const TomlValue& value) {
  TomlValue& field = field_at(document, path);
  field.data = value.data;
}

}  // namespace talus
