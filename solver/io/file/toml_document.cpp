#include "solver/io/file/toml_document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>

#include "solver/base/error.hpp"
#include "verification/record/error.hpp"
#include "verification/record/utf8.hpp"
#include "verification/record/whole_file.hpp"

namespace talus {
namespace {

int line_of(const toml::source_region& source) { return static_cast<int>(source.begin.line); }

TomlValue copied(const toml::node& node);

TomlTable copied_table(const toml::table& table) {
  TomlTable result;
  for (const auto& [key, value] : table) {
    TomlValue copy = copied(value);
    // Errors of a value are reported on the line of its key, where a reader expects them; an array of tables has no
    // line of a key.
    if (!value.is_array_of_tables() && !value.is_table()) copy.line = line_of(key.source());
    result.push_back({std::string{key.str()}, std::move(copy)});
  }
  // toml++ sorts keys; messages and models use the file's order.
  std::stable_sort(result.begin(), result.end(),
                   [](const TomlEntry& a, const TomlEntry& b) { return a.value.line < b.value.line; });
  return result;
}

TomlValue copied(const toml::node& node) {
  TomlValue value;
  value.line = line_of(node.source());
  if (const auto* text = node.as_string()) {
    value.data = text->get();
  } else if (const auto* number = node.as_floating_point()) {
    value.data = number->get();
  } else if (const auto* whole = node.as_integer()) {
    value.data = whole->get();
  } else if (const auto* flag = node.as_boolean()) {
    value.data = flag->get();
  } else if (const auto* array = node.as_array()) {
    TomlArray elements;
    for (const toml::node& element : *array)
      elements.push_back(copied(element));
    if (!elements.empty() && value.line == 0) value.line = elements.front().line;
    value.data = std::move(elements);
  } else if (const auto* table = node.as_table()) {
    value.data = copied_table(*table);
  } else {
    value.data = TomlDate{};
  }
  return value;
}

/// Rejects keys of very many parts, a.b.c: the library nests a table for each, and its destructor overflows the stack.
void refuse_long_keys(std::string_view text, std::string_view name) {
  constexpr std::size_t maximum = 100;
  std::size_t line = 1, parts = 1;
  bool after_key = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (letter == '"' || letter == '\'') {
      for (++i; i < text.size() && text[i] != letter && text[i] != '\n'; ++i)
        if (letter == '"' && text[i] == '\\') ++i;
      if (i < text.size() && text[i] == '\n') --i;
      after_key = true;
    } else if (std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '-') {
      after_key = true;
    } else if (letter == '.' && after_key) {
      after_key = false;
      if (++parts > maximum)
        throw InputError{
            fmt::format("{}:{}: a key has more than {} parts, which are joined by dots", name, line, maximum)};
    } else if (letter != ' ' && letter != '\t') {
      line += letter == '\n' ? 1 : 0;
      parts = 1, after_key = false;
    }
  }
}

}  // namespace

std::string found(const TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.data))
    return fmt::format("\"{}\"", records::shown_text(*text));
  if (const auto* number = std::get_if<double>(&value.data)) {
    // As it is written, so that 11.0 is not called a wrong whole number 11.
    const std::string text = fmt::format("{}", *number);
    return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
  }
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return fmt::format("{}", *whole);
  if (const auto* flag = std::get_if<bool>(&value.data)) return *flag ? "true" : "false";
  if (const auto* array = std::get_if<TomlArray>(&value.data)) {
    std::vector<std::string> elements;
    for (const TomlValue& element : *array)
      elements.push_back(found(element));
    const std::string text = fmt::format("[{}]", fmt::join(elements, ", "));
    return text.size() <= 60 ? text : fmt::format("an array of {}", array->size());
  }
  return std::holds_alternative<TomlTable>(value.data) ? "a table" : "a date or time";
}

TomlValue parse_toml(std::string_view text, std::string_view name) {
  refuse_long_keys(text, name);
  try {
    return copied(toml::parse(text, std::string{name}));
  } catch (const toml::parse_error& error) {
    throw InputError{fmt::format("{}:{}: not TOML: {}", name, line_of(error.source()), error.description())};
  }
}

std::string read_text(const std::filesystem::path& file) {
  try {
    return records::read_whole(file);
  } catch (const records::FileError& error) {
    throw IoError{error.what()};
  }
}

}  // namespace talus
