#pragma once

#include <toml++/toml.h>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

/// TOML files of mutants, read strictly.
namespace talus::mutants {

/// Throws std::runtime_error with file, line and `text_of`.
[[noreturn]] void refuse(const toml::source_region& region, const std::string& message);

/// Parses a TOML file. Errors: std::runtime_error with file and line if it is not TOML.
[[nodiscard]] toml::table parsed(const std::filesystem::path& file);

/// The tables of [[key]]. Errors: std::runtime_error if one is not a table, or has an unknown key.
[[nodiscard]] std::vector<const toml::table*> tables_of(const toml::table& table, std::string_view key,
                                                        std::initializer_list<std::string_view> known);

/// The string of a key. Errors: std::runtime_error if it is missing, or empty although it must not be.
[[nodiscard]] std::string text_of(const toml::table& table, std::string_view key, bool may_be_empty = false);

}  // namespace talus::mutants
