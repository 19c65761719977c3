/// Reading JSON so that every complaint names file and field. Heavy: include it in .cpp files only.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "reports/error.hpp"

namespace talus::reports {

using nlohmann::json;

/// A JSON value that knows where it stands, so that every complaint names file and field.
class Node {
 public:
  Node(const json& value, std::string place) : value_(&value), place_(std::move(place)) {}

  [[noreturn]] void complain(const std::string& words) const { throw RecordError(place_ + ": " + words); }

  [[nodiscard]] bool has(const char* key) const {
    if (!value_->is_object()) complain(fmt::format("must be an object, found {}", found()));
    return value_->contains(key) && !(*value_)[key].is_null();
  }

  [[nodiscard]] Node at(const char* key) const {
    if (!has(key)) throw RecordError(fmt::format("{}.{}: is missing", place_, key));
    return {(*value_)[key], place_ + "." + key};
  }

  [[nodiscard]] std::string text() const {
    if (!value_->is_string()) complain(fmt::format("must be a text, found {}", found()));
    return value_->get<std::string>();
  }

  [[nodiscard]] std::string words() const {
    const std::string result = text();
    if (result.find_first_not_of(" \t\n") == std::string::npos) complain("must not be empty");
    return result;
  }

  [[nodiscard]] std::string one_of(std::initializer_list<const char*> allowed) const {
    const std::string result = text();
    if (std::find(allowed.begin(), allowed.end(), result) == allowed.end()) {
      complain(fmt::format("'{}' is not known; known: {}", result, fmt::join(allowed, ", ")));
    }
    return result;
  }

  [[nodiscard]] double number() const {
    if (value_->is_number()) return value_->get<double>();
    const std::string word = value_->is_string() ? value_->get<std::string>() : "";
    if (word == "nan" || word == "-nan") return std::numeric_limits<double>::quiet_NaN();
    if (word == "inf") return std::numeric_limits<double>::infinity();
    if (word == "-inf") return -std::numeric_limits<double>::infinity();
    complain(fmt::format("must be a number, found {}", found()));
  }

  [[nodiscard]] double finite() const {
    const double result = number();
    if (!std::isfinite(result)) complain("must be a finite number");
    return result;
  }

  [[nodiscard]] int integer() const {
    if (!value_->is_number_integer()) complain(fmt::format("must be a whole number, found {}", found()));
    return value_->get<int>();
  }

  [[nodiscard]] bool flag() const {
    if (!value_->is_boolean()) complain(fmt::format("must be true or false, found {}", found()));
    return value_->get<bool>();
  }

  [[nodiscard]] std::vector<Node> list() const {
    if (!value_->is_array()) complain(fmt::format("must be a list, found {}", found()));
    std::vector<Node> result;
    for (std::size_t i = 0; i < value_->size(); ++i)
      result.emplace_back((*value_)[i], fmt::format("{}[{}]", place_, i));
    return result;
  }

  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> result;
    for (const Node& node : list())
      result.push_back(node.text());
    return result;
  }

  [[nodiscard]] std::map<std::string, std::string> dictionary() const {
    if (!value_->is_object()) complain(fmt::format("must be an object, found {}", found()));
    std::map<std::string, std::string> result;
    for (const auto& item : value_->items())
      result[item.key()] = Node(item.value(), place_ + "." + item.key()).text();
    return result;
  }

  // Fields that may be absent.
  [[nodiscard]] std::string text_or_empty(const char* key) const { return has(key) ? at(key).text() : std::string{}; }
  [[nodiscard]] bool flag_or_false(const char* key) const { return has(key) && at(key).flag(); }
  [[nodiscard]] std::vector<Node> list_or_empty(const char* key) const {
    return has(key) ? at(key).list() : std::vector<Node>{};
  }

 private:
  [[nodiscard]] std::string found() const {
    const std::string text = value_->dump();
    return text.size() > 60 ? text.substr(0, 57) + "..." : text;
  }

  const json* value_;
  std::string place_;
};

}  // namespace talus::reports
