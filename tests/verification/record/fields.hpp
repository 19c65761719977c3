#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "tests/verification/record/error_message.hpp"
#include "verification/record/json_node.hpp"

/// A member of a JSON document: its path ("record.checks[0].name"), its key, and a pointer to it.
struct Field {
  std::string path;
  std::string key;
  talus::records::Json::json_pointer pointer;
};

/// Collects all members of all objects within a value.
inline void collect(const talus::records::Json& value, const std::string& path,
                    const talus::records::Json::json_pointer& pointer, std::vector<Field>& fields) {
  if (value.is_object()) {
    for (const auto& item : value.items()) {
      const std::string path_of_item = path + "." + item.key();
      fields.push_back({path_of_item, item.key(), pointer / item.key()});
      collect(item.value(), path_of_item, pointer / item.key(), fields);
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      collect(value[i], path + "[" + std::to_string(i) + "]", pointer / i, fields);
  }
}

/// Checks that `read` refuses the document if any member is absent, except those whose keys may be absent, and if any
/// member has a value of another type; the error must give the member's path.
inline void demand_strict(const talus::records::Json& good, const std::string& root,
                          const std::set<std::string>& may_be_absent,
                          const std::function<void(const talus::records::Json&)>& read) {
  using talus::records::Json;
  std::vector<Field> fields;
  collect(good, root, Json::json_pointer{}, fields);
  BOOST_TEST(fields.size() > 20u);
  for (const Field& field : fields) {
    Json without = good;
    without[field.pointer.parent_pointer()].erase(field.key);
    const std::string absent = error_message([&] { read(without); });
    if (may_be_absent.count(field.key) == 0) BOOST_TEST(holds(absent, field.path + ": is missing"), absent);
    // No field is a list of lists of numbers.
    Json other = good;
    other[field.pointer] = Json::array({Json::array({1})});
    const std::string changed = error_message([&] { read(other); });
    BOOST_TEST(holds(changed, field.path), field.path << ": " << changed);
  }
}
