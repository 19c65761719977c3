#pragma once

#include <toml++/toml.h>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

/// TOML files of mutants, read strictly.
namespace talus::mutants {

/// Throws std::runtime_error: file, line, words.
[[noreturn]] void refuse(const toml::source_region& place, const std::string& words);

/// Errors: std::runtime_error with file and line if it is no TOML.
[[nodiscard]] toml::table parsed(const std::filesystem::path& file);

/// The tables of [[key]]. Errors: std::runtime_error if one is no table, or has a key that is not known.
[[nodiscard]] std::vector<const toml::table*> tables_of(const toml::table& table, std::string_view key,
                                                        std::initializer_list<std::string_view> known);

/// A text. Errors: std::runtime_error if it is missing, or empty and must not be.
[[nodiscard]] std::string words(const toml::table& table, std::string_view key, bool may_be_empty = false);

}  // namespace talus::mutants
