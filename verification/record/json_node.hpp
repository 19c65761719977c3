/// Strict reading of JSON. Heavy: include it in .cpp files only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "verification/record/error.hpp"

namespace talus::records {

/// Keys keep the order of the file.
using Json = nlohmann::ordered_json;

/// The JSON document in a file. FileError if the file cannot be read; RecordError if empty, too deep or not JSON.
[[nodiscard]] Json read_json(const std::filesystem::path& file);

/// A JSON value and its path, e.g. "results.json: results.cases[0].checks[2]". Each access throws RecordError with the
/// path, what was found and what is allowed if the value is not of the requested kind. The document must outlive the
/// node.
class Node {
 public:
  Node(const Json& value, std::string path) : value_(&value), path_(std::move(path)) {}

  /// Throws RecordError: the path, then `what`.
  [[noreturn]] void fail(const std::string& what) const;
  /// The same for a part of this value, e.g. "series[1].colour"; empty: the value itself.
  [[noreturn]] void fail_at(const std::string& part, const std::string& what) const;
  /// Throws RecordError: "must be ALLOWED, found VALUE", with a long value truncated.
  [[noreturn]] void refuse(const std::string& allowed) const;

  /// Whether this object has `key` with a value other than null.
  [[nodiscard]] bool has(const char* key) const;
  /// The member of an object; RecordError if it is missing or null.
  [[nodiscard]] Node at(const char* key) const;
  [[nodiscard]] bool is_null(const char* key) const;

  [[nodiscard]] std::string text() const;
  /// A text that is neither empty nor blank.
  [[nodiscard]] std::string nonempty_text() const;
  /// A text from the list.
  [[nodiscard]] std::string one_of(const std::vector<std::string>& allowed) const;
  /// Maximum size of a file name [bytes]. Linux allows 255; the rest is for the extension and the temporary name.
  static constexpr std::size_t longest_name = 200;
  /// Maximum size of a name that becomes a part of file names: two with an extension are a file name [bytes].
  static constexpr std::size_t longest_part = 90;
  /// A file name of at most `longest` bytes that cannot refer to another folder.
  [[nodiscard]] std::string file_name(std::size_t longest = longest_name) const;
  /// Any number; non-finite ones by their names in json_number().
  [[nodiscard]] double number() const;
  [[nodiscard]] double finite() const;
  [[nodiscard]] int integer() const;
  /// An integer >= 0.
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] bool flag() const;
  [[nodiscard]] std::vector<Node> list() const;
  /// The members of an object in the order of the file.
  [[nodiscard]] std::vector<std::pair<std::string, Node>> members() const;
  [[nodiscard]] std::vector<std::string> texts() const;

  [[nodiscard]] const Json& json() const { return *value_; }

 private:
  void demand_object() const;

  const Json* value_;
  std::string path_;
};

}  // namespace talus::records
