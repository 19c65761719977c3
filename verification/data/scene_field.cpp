#include "verification/data/scene_field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <sstream>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/io/file/toml_field.hpp"

namespace talus::verification {

namespace {

std::vector<std::string> keys_of(const toml::table& table) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : table)
    keys.emplace_back(key.str());
  return keys;
}

/// The table of a list that has this name.
toml::node* named(toml::array& list, const std::string& name, const std::string& field) {
  std::vector<std::string> names;
  for (toml::node& element : list) {
    const toml::table* const table = element.as_table();
    if (table == nullptr) continue;
    names.push_back((*table)["name"].value_or(std::string{}));
    if (names.back() == name) return &element;
  }
  throw InputError{fmt::format("'{}': {}", field, unknown_name("name", name, names).what())};
}

}  // namespace

std::string with_field(const std::string& scene, const std::string& field, const std::string& value) {
  toml::table root, given;
  try {
    root = toml::parse(scene);
    given = toml::parse("value = " + value);
  } catch (const toml::parse_error& wrong) {
    throw InputError{fmt::format("'{}' = {}: not TOML: {}", field, value, wrong.description())};
  }
  const toml::node& fresh = *given.get("value");
  const std::vector<FieldKey> steps = field_keys(field);
  toml::node* at = &root;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool last = i + 1 == steps.size();
    if (toml::array* const list = at->as_array()) {
      at = named(*list, steps[i].key, field);
      if (last || steps[i].index)
        throw InputError{fmt::format("'{}': it must end with a field of '{}'", field, steps[i].key)};
      continue;
    }
    toml::table* const table = at->as_table();
    if (table == nullptr)
      throw InputError{fmt::format("'{}': nothing can be below '{}', which is a value; give a shorter path", field,
                                   steps[i - 1].key)};
    if (last && !steps[i].index) {
      if (const toml::node* const old = table->get(steps[i].key);
          old != nullptr && (old->is_table() || old->is_array()))
        throw InputError{
            fmt::format("'{}': found {}; it must be a value", field, old->is_table() ? "a table" : "an array")};
      table->insert_or_assign(steps[i].key, fresh);
      break;
    }
    at = table->get(steps[i].key);
    if (at == nullptr)
      throw InputError{fmt::format("'{}': {}", field, unknown_name("field", steps[i].key, keys_of(*table)).what())};
    if (!steps[i].index) continue;
    toml::array* const list = at->as_array();
    if (list == nullptr)
      throw InputError{
          fmt::format("'{}': '{}' is not an array; give it without [{}]", field, steps[i].key, *steps[i].index)};
    if (*steps[i].index >= list->size())
      throw InputError{fmt::format("'{}': '{}' has no element [{}]; give one of its {} elements, from [0] on", field,
                                   steps[i].key, *steps[i].index, list->size())};
    if (last) {
      list->replace(list->cbegin() + static_cast<std::ptrdiff_t>(*steps[i].index), fresh);
    } else {
      at = list->get(*steps[i].index);
    }
  }
  std::ostringstream text;
  text << root << '\n';
  return text.str();
}

}  // namespace talus::verification
