/// Types that are written to and read from JSON with a single list of their fields. Heavy: include it in .cpp files
/// only.
///
/// Each type lists its fields once, in the order of the file:
///
///     void fields(auto& f, Like<Trace> auto& trace) {
///       f.words("id", trace.requirement);
///       f.value("checks", trace.checks);
///     }
///
/// Rules that concern several fields are checked in `demand_sound(const Node&, const Trace&)`, which is called after
/// reading if it exists. Unknown keys are ignored: a later version may add some within one schema.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "verification/record/json_node.hpp"
#include "verification/record/json_number.hpp"
#include "verification/record/names.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::records {

/// T is U or const U.
template <class T, class U>
concept Like = std::same_as<std::remove_const_t<T>, U>;

/// Set of fields in a file.
enum class Completeness {
  complete,  ///< all fields that Writer writes
  sparse,    ///< `defaulted` fields may be absent
};

using TextPairs = std::vector<std::pair<std::string, std::string>>;

template <class T>
[[nodiscard]] Json json_of(const T& value);

/// Passed to a list of fields, appends each field to a JSON object.
class Writer {
 public:
  template <class T>
  void value(const char* key, const T& value) {
    json_[key] = json_of(value);
  }
  template <class T>
  void value_if(bool written, const char* key, const T& value) {
    if (written) json_[key] = json_of(value);
  }
  template <class T>
  void defaulted(const char* key, const T& value) {
    json_[key] = json_of(value);
  }
  template <class T>
  void derived(const char* key, const T& value, const char* /*why*/ = "") {
    json_[key] = json_of(value);
  }
  /// Reserves the position of a field that a later `derived` call writes.
  void reserve(const char* key) { json_[key] = nullptr; }
  template <class T>
  void list(const char* key, const std::vector<T>& values, auto&& list_of_fields) {
    Json& json = json_[key] = Json::array();
    for (const T& value : values) {
      Writer writer;
      list_of_fields(writer, value);
      json.push_back(std::move(writer.json_));
    }
  }
  void nonempty_text(const char* key, const std::string& value, const char* = nullptr) { json_[key] = value; }
  void file_name(const char* key, const std::string& value, std::size_t = 0) { json_[key] = value; }
  void number(const char* key, double value) { json_[key] = json_number(value); }
  void number_or_null(bool known, const char* key, double value) {
    json_[key] = known ? json_number(value) : Json(nullptr);
  }

  [[nodiscard]] Json json() && { return std::move(json_); }

 private:
  Json json_ = Json::object();
};

template <class T>
Json json_of(const T& value) {
  if constexpr (std::same_as<T, double>) {
    return json_number(value);
  } else if constexpr (std::same_as<T, char>) {
    return std::string(1, value);
  } else if constexpr (Named<T>) {
    return name_of(value);
  } else if constexpr (std::same_as<T, TextPairs>) {
    Json json = Json::object();
    for (const auto& [key, text] : value)
      json[key] = text;
    return json;
  } else if constexpr (requires { typename T::value_type; } && !std::same_as<T, std::string>) {
    if constexpr (std::same_as<T, std::optional<typename T::value_type>>) {
      return value ? json_of(*value) : Json(nullptr);
    } else {
      Json json = Json::array();
      for (const auto& each : value)
        json.push_back(json_of(each));
      return json;
    }
  } else if constexpr (std::is_class_v<T> && !std::same_as<T, std::string>) {
    Writer writer;
    fields(writer, value);
    return std::move(writer).json();
  } else {
    return value;
  }
}

template <class T>
void read_into(const Node& node, T& value, Completeness completeness);

/// Passed to a list of fields, reads each from a JSON object. RecordError with file and path for invalid content.
class Reader {
 public:
  Reader(Node node, Completeness completeness) : node_(std::move(node)), completeness_(completeness) {}

  /// A mandatory field; numbers must be finite.
  template <class T>
  void value(const char* key, T& value) const {
    read_into(node_.at(key), value, completeness_);
  }
  /// A field that is written only under a condition, and keeps its default where it is absent.
  template <class T>
  void value_if(bool /*written*/, const char* key, T& value) const {
    if (node_.has(key)) read_into(node_.at(key), value, completeness_);
  }
  /// A field that sparse files may omit to keep its default.
  template <class T>
  void defaulted(const char* key, T& value) const {
    if (completeness_ == Completeness::complete || node_.has(key)) read_into(node_.at(key), value, completeness_);
  }
  /// A field that follows from others, which precede it in the list.
  template <class T>
  void derived(const char* key, const T& value, const char* why = "") const {
    demand_equal(node_.at(key), json_of(value), why);
  }
  void reserve(const char* /*key*/) const {}
  /// A list of objects whose fields depend on the enclosing object.
  template <class T>
  void list(const char* key, std::vector<T>& values, auto&& list_of_fields) const {
    values.clear();
    for (const Node& each : node_.at(key).list()) {
      const Reader reader{each, completeness_};
      list_of_fields(reader, values.emplace_back());
    }
  }
  /// `former`: the key in earlier files.
  void nonempty_text(const char* key, std::string& value, const char* former = nullptr) const {
    const bool is_former = former != nullptr && !node_.has(key) && node_.has(former);
    value = node_.at(is_former ? former : key).nonempty_text();
  }
  void file_name(const char* key, std::string& value, std::size_t longest = Node::longest_name) const {
    value = node_.at(key).file_name(longest);
  }
  /// A number that may be non-finite.
  void number(const char* key, double& value) const { value = node_.at(key).number(); }
  void number_or_null(bool known, const char* key, double& value) const {
    if (known) return number(key, value);
    if (!node_.is_null(key)) node_.at(key).refuse("null: the check was not made");
  }

 private:
  /// If both are objects, the error names the differing member.
  static void demand_equal(const Node& node, const Json& expected, const char* why) {
    if (!expected.is_object()) {
      if (node.json() != expected) node.refuse(expected.dump() + why);
      return;
    }
    for (const auto& item : expected.items())
      demand_equal(node.at(item.key().c_str()), item.value(), why);
  }

  Node node_;
  Completeness completeness_;
};

template <class T>
void read_into(const Node& node, T& value, Completeness completeness) {
  if constexpr (std::same_as<T, std::string>) {
    value = node.text();
  } else if constexpr (std::same_as<T, char>) {
    const std::string text = node.text();
    if (text.size() != 1) node.refuse("one letter");
    value = text.front();
  } else if constexpr (std::same_as<T, bool>) {
    value = node.flag();
  } else if constexpr (std::same_as<T, double>) {
    value = node.finite();
  } else if constexpr (std::same_as<T, int>) {
    value = node.integer();
  } else if constexpr (std::unsigned_integral<T>) {
    const std::uint64_t count = node.count();
    if (count > std::numeric_limits<T>::max()) node.refuse("a smaller number");
    value = static_cast<T>(count);
  } else if constexpr (Named<T>) {
    value = value_named<T>(node.one_of(all_names<T>())).value();
  } else if constexpr (std::same_as<T, TextPairs>) {
    value.clear();
    for (const auto& [key, member] : node.members())
      value.emplace_back(key, member.text());
  } else if constexpr (requires { typename T::value_type; }) {
    if constexpr (std::same_as<T, std::optional<typename T::value_type>>) {
      read_into(node, value.emplace(), completeness);
    } else {
      value.clear();
      for (const Node& each : node.list())
        read_into(each, value.emplace_back(), completeness);
    }
  } else {
    const Reader reader{node, completeness};
    fields(reader, value);
    if constexpr (requires { demand_sound(node, value); }) demand_sound(node, value);
  }
}

/// The object in a file; `what` names it in messages. FileError if the file cannot be read; RecordError.
template <class T>
[[nodiscard]] T read_file(const std::filesystem::path& file, const char* what) {
  const Json json = read_json(file);
  T value;
  read_into(Node{json, file.filename().string() + ": " + what}, value, Completeness::complete);
  return value;
}

/// Writes an object to a file. FileError.
template <class T>
void write_file(const T& value, const std::filesystem::path& file) {
  write_whole(file, json_of(value).dump(1) + "\n");
}

/// Throws RecordError, naming the list, if two of `things` have the same name.
template <class Things>
void demand_distinct_names(const Node& node, const char* key, const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things)
    names.push_back(thing.name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) node.at(key).fail("'" + *twice + "' occurs twice");
}

}  // namespace talus::records
