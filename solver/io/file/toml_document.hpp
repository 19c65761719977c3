#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace talus {

struct TomlValue;
struct TomlEntry;
/// Elements of an array, in the file's order.
using TomlArray = std::vector<TomlValue>;
/// Keys and values of a table, in the file's order.
using TomlTable = std::vector<TomlEntry>;
/// A date or time, which TOML has but a scene does not use.
struct TomlDate {};

/// One value of a TOML file and its line.
struct TomlValue {
  std::variant<std::string, double, std::int64_t, bool, TomlDate, TomlArray, TomlTable> data;
  int line{};  ///< counted from 1; of a table: its header or opening brace
};

/// One key of a table with its value.
struct TomlEntry {
  std::string key;
  TomlValue value;
};

/// The value as shown in a message, control characters escaped: `"3 kg"`, `3`, `true`, `["1 m", "2 m"]` (beyond 60
/// characters "an array of 12"), "a table".
[[nodiscard]] std::string found(const TomlValue& value);

/// Parses TOML text; `name` is the file named in errors.
/// Errors: InputError "name:line: not TOML: ...".
[[nodiscard]] TomlValue parse_toml(std::string_view text, std::string_view name);

/// The text of a file, pipe or device. Errors: IoError with the system's reason, or with the limit of its size
/// (records::read_whole).
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

}  // namespace talus
