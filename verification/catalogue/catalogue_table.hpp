#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/io/file/toml_document.hpp"

namespace talus::verification {

/// One table of a TOML file of the verification, read key by key: texts, numbers, lists of texts, and tables of them.
/// Every error is an InputError such as "peers.toml:17: check 'DEM01': form: found 3; it must be a text in quotes",
/// with file, line, table, key, what was found and what is allowed. Unknown keys are rejected, with the nearest known
/// key.
class CatalogueTable {
 public:
  /// Reads the file as a table. Errors: IoError if it cannot be read, InputError if it is not TOML.
  CatalogueTable(const std::filesystem::path& file, const std::vector<std::string>& keys);

  /// A required, non-empty text. Line breaks and the spaces around them are replaced by one space.
  [[nodiscard]] std::string text(std::string_view key) const;
  /// As text(); empty if the key is absent.
  [[nodiscard]] std::string text_or_empty(std::string_view key) const;
  /// A required array of texts, none of them empty or repeated. The array may be empty.
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  /// A required array of tables with these keys; messages refer to each by `noun` and the text of its key `name`.
  [[nodiscard]] std::vector<CatalogueTable> tables(std::string_view key, std::string_view noun, std::string_view name,
                                                   const std::vector<std::string>& keys) const;
  /// The entries of a table whose keys are names and whose values are texts, in file order.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> entries(std::string_view key) const;

  /// A required finite number.
  [[nodiscard]] double number(std::string_view key) const;
  /// A required text, number or truth value, as written in TOML: "\"5 m/s\"", "0.3", "true".
  [[nodiscard]] std::string literal(std::string_view key) const;
  /// Whether the key has a text.
  [[nodiscard]] bool is_text(std::string_view key) const;

  /// File, line, table and key, as messages name them.
  [[nodiscard]] std::string location_of(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
  /// Throws InputError about a key, or about one of the entries under it.
  [[noreturn]] void fail(std::string_view key, std::string_view message, std::string_view entry = "") const;

 private:
  CatalogueTable(std::string file, TomlValue value, std::string noun, const std::vector<std::string>& keys);

  const TomlValue* find(std::string_view key) const;
  const TomlValue& demand(std::string_view key) const;
  std::string text_of(std::string_view key, const TomlValue& value) const;
  std::string location(int line, std::string_view key) const;
  [[noreturn]] void fail_at(int line, std::string_view key, std::string_view message) const;

  std::string file_;
  TomlTable table_;
  int line_;
  std::string noun_;  ///< "check 'DEM01'"; empty for the file
};

}  // namespace talus::verification
