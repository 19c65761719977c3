#include "verification/record/json_node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/record/json_depth.hpp"
#include "verification/record/json_fault.hpp"
#include "verification/record/json_number.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::records {

Json read_json(const std::filesystem::path& file) {
  const std::string text = read_whole(file);
  if (text.empty()) throw RecordError(file.string() + ": is empty; give a file that Talus wrote");
  demand_shallow_json(text, file);
  try {
    return Json::parse(text);
  } catch (const Json::exception& fault) {
    throw RecordError(fmt::format("{}: is truncated or not JSON: {}", file.string(), json_fault(fault)));
  }
}

void Node::fail(const std::string& what) const { throw RecordError(path_ + ": " + what); }

void Node::fail_at(const std::string& part, const std::string& what) const {
  throw RecordError(fmt::format("{}{}{}: {}", path_, part.empty() ? "" : ".", part, what));
}

void Node::refuse(const std::string& allowed) const {
  const std::string text = value_->dump(-1, ' ', false, Json::error_handler_t::replace);
  fail(fmt::format("must be {}, found {}", allowed, text.size() > 60 ? text.substr(0, 57) + "..." : text));
}

void Node::demand_object() const {
  if (!value_->is_object()) refuse("an object");
}

bool Node::has(const char* key) const {
  demand_object();
  return value_->contains(key) && !(*value_)[key].is_null();
}

bool Node::is_null(const char* key) const {
  demand_object();
  return value_->contains(key) && (*value_)[key].is_null();
}

Node Node::at(const char* key) const {
  demand_object();
  const auto member = value_->find(key);
  if (member == value_->end()) throw RecordError(fmt::format("{}.{}: is missing", path_, key));
  if (member->is_null()) throw RecordError(fmt::format("{}.{}: is null", path_, key));
  return {*member, path_ + "." + key};
}

std::string Node::text() const {
  if (!value_->is_string()) refuse("a text");
  return value_->get<std::string>();
}

std::string Node::nonempty_text() const {
  std::string result = text();
  if (result.find_first_not_of(" \t\n") == std::string::npos) refuse("a text that is not empty");
  return result;
}

std::string Node::one_of(const std::vector<std::string>& allowed) const {
  std::string result = value_->is_string() ? value_->get<std::string>() : std::string{};
  if (!value_->is_string() || std::find(allowed.begin(), allowed.end(), result) == allowed.end())
    refuse(fmt::format("one of {}", fmt::join(allowed, ", ")));
  return result;
}

std::string Node::file_name(std::size_t longest) const {
  std::string name = nonempty_text();
  const bool control = std::any_of(name.begin(), name.end(), [](char letter) {
    return static_cast<unsigned char>(letter) < ' ' || letter == '\x7f';
  });
  if (name.find('/') != std::string::npos || name.front() == '.' || control) refuse("a plain file name");
  if (name.size() > longest) refuse(fmt::format("a file name of at most {} bytes", longest));
  return name;
}

double Node::number() const {
  const auto value = number_of(*value_);
  if (!value) refuse("a number");
  return *value;
}

double Node::finite() const {
  const double value = number();
  if (!std::isfinite(value)) refuse("a finite number");
  return value;
}

int Node::integer() const {
  using Limits = std::numeric_limits<int>;
  if (!value_->is_number_integer()) refuse("a whole number");
  const auto value = value_->get<std::int64_t>();
  if (value < Limits::min() || value > Limits::max()) {
    refuse(fmt::format("a whole number from {} to {}", Limits::min(), Limits::max()));
  }
  return static_cast<int>(value);
}

std::uint64_t Node::count() const {
  if (!value_->is_number_unsigned()) refuse("a whole number >= 0");
  return value_->get<std::uint64_t>();
}

bool Node::flag() const {
  if (!value_->is_boolean()) refuse("true or false");
  return value_->get<bool>();
}

std::vector<Node> Node::list() const {
  if (!value_->is_array()) refuse("a list");
  std::vector<Node> result;
  result.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.emplace_back((*value_)[i], fmt::format("{}[{}]", path_, i));
  return result;
}

std::vector<std::pair<std::string, Node>> Node::members() const {
  demand_object();
  std::vector<std::pair<std::string, Node>> result;
  for (const auto& item : value_->items())
    result.emplace_back(item.key(), Node{item.value(), path_ + "." + item.key()});
  return result;
}

std::vector<std::string> Node::texts() const {
  std::vector<std::string> result;
  for (const Node& node : list())
    result.push_back(node.text());
  return result;
}

}  // namespace talus::records
