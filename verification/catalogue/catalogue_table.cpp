#include "verification/catalogue/catalogue_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/error.hpp"

namespace talus::verification {

namespace {

TomlValue value_of(const std::filesystem::path& file) {
  TomlValue value = parse_toml(read_text(file), file.string());
  value.line = 1;
  return value;
}

/// Removes spaces at both ends; replaces a line break with the spaces around it by one space.
std::string joined_lines(std::string_view text) {
  const std::string_view blanks = " \t\r\n";
  std::string joined;
  while (true) {
    const std::size_t start = text.find_first_not_of(blanks);
    if (start == std::string_view::npos) return joined;
    text.remove_prefix(start);
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(line.size());
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    joined += (joined.empty() ? "" : " ") + std::string{line};
  }
}

}  // namespace

CatalogueTable::CatalogueTable(const std::filesystem::path& file, const std::vector<std::string>& keys)
    : CatalogueTable{file.string(), value_of(file), "", keys} {}

CatalogueTable::CatalogueTable(std::string file, TomlValue value, std::string noun,
                               const std::vector<std::string>& keys)
    : file_{std::move(file)},
      table_{std::move(std::get<TomlTable>(value.data))},
      line_{value.line},
      noun_{std::move(noun)} {
  for (const TomlEntry& entry : table_) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    fail_at(entry.value.line, "", unknown_name("key", entry.key, keys).what());
  }
}

const TomlValue* CatalogueTable::find(std::string_view key) const {
  const auto entry = std::find_if(table_.begin(), table_.end(), [&](const TomlEntry& e) { return e.key == key; });
  return entry == table_.end() ? nullptr : &entry->value;
}

const TomlValue& CatalogueTable::demand(std::string_view key) const {
  const TomlValue* const value = find(key);
  if (value == nullptr) fail_at(line_, key, "it is missing");
  return *value;
}

std::string CatalogueTable::location(int line, std::string_view key) const {
  std::string location = fmt::format("{}:{}: ", file_, line);
  if (!noun_.empty()) location += noun_ + ": ";
  if (!key.empty()) location += fmt::format("{}: ", key);
  return location;
}

std::string CatalogueTable::location_of(std::string_view key) const { return location(demand(key).line, key); }

void CatalogueTable::fail_at(int line, std::string_view key, std::string_view message) const {
  throw InputError{location(line, key).append(message)};
}

void CatalogueTable::fail(std::string_view key, std::string_view message, std::string_view entry) const {
  const TomlValue& value = demand(key);
  int line = value.line;
  if (const auto* table = std::get_if<TomlTable>(&value.data)) {
    for (const TomlEntry& e : *table) {
      if (e.key == entry) line = e.value.line;
    }
  }
  fail_at(line, key, entry.empty() ? std::string{message} : fmt::format("{}: {}", entry, message));
}

std::string CatalogueTable::text_of(std::string_view key, const TomlValue& value) const {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) fail_at(value.line, key, fmt::format("found {}; it must be a text in quotes", found(value)));
  std::string joined = joined_lines(*text);
  if (joined.empty()) fail_at(value.line, key, fmt::format("found {}; it must not be empty", found(value)));
  return joined;
}

std::string CatalogueTable::text(std::string_view key) const { return text_of(key, demand(key)); }

std::string CatalogueTable::text_or_empty(std::string_view key) const { return has(key) ? text(key) : ""; }

bool CatalogueTable::is_text(std::string_view key) const {
  return std::holds_alternative<std::string>(demand(key).data);
}

double CatalogueTable::number(std::string_view key) const {
  const TomlValue& value = demand(key);
  double number = std::numeric_limits<double>::quiet_NaN();
  if (const auto* real = std::get_if<double>(&value.data)) number = *real;
  if (const auto* integer = std::get_if<std::int64_t>(&value.data)) number = static_cast<double>(*integer);
  if (!std::isfinite(number)) fail_at(value.line, key, fmt::format("found {}; it must be a number", found(value)));
  return number;
}

std::string CatalogueTable::literal(std::string_view key) const {
  const TomlValue& value = demand(key);
  if (std::holds_alternative<TomlArray>(value.data) || std::holds_alternative<TomlTable>(value.data) ||
      std::holds_alternative<TomlDate>(value.data))
    fail_at(value.line, key, fmt::format("found {}; it must be a text, a number, true or false", found(value)));
  const auto* text = std::get_if<std::string>(&value.data);
  if (text != nullptr && text->find_first_of("\"\\\n") != std::string::npos)
    fail_at(value.line, key, "found a text with a quote, a backslash or a line break; give one without");
  return found(value);
}

std::vector<std::string> CatalogueTable::texts(std::string_view key) const {
  const TomlValue& value = demand(key);
  const auto* array = std::get_if<TomlArray>(&value.data);
  if (array == nullptr) {
    fail_at(value.line, key, fmt::format("found {}; it must be an array of texts, [\"..\", \"..\"]", found(value)));
  }
  std::vector<std::string> texts;
  for (const TomlValue& element : *array) {
    texts.push_back(text_of(key, element));
    if (std::count(texts.begin(), texts.end(), texts.back()) > 1)
      fail_at(element.line, key, fmt::format("found \"{}\" twice; each may be given once", texts.back()));
  }
  return texts;
}

std::vector<CatalogueTable> CatalogueTable::tables(std::string_view key, std::string_view noun, std::string_view name,
                                                   const std::vector<std::string>& keys) const {
  const TomlValue& value = demand(key);
  const auto* array = std::get_if<TomlArray>(&value.data);
  const auto is_table = [](const TomlValue& element) { return std::holds_alternative<TomlTable>(element.data); };
  if (array == nullptr || !std::all_of(array->begin(), array->end(), is_table)) {
    fail_at(value.line, key, fmt::format("found {}; it must be an array of tables, [[{}]]", found(value), key));
  }
  std::vector<CatalogueTable> tables;
  for (const TomlValue& element : *array) {
    std::string called{noun};
    for (const TomlEntry& entry : std::get<TomlTable>(element.data)) {
      const auto* text = std::get_if<std::string>(&entry.value.data);
      if (entry.key == name && text != nullptr) called += fmt::format(" '{}'", *text);
    }
    tables.push_back(CatalogueTable{file_, element, std::move(called), keys});
  }
  return tables;
}

std::vector<std::pair<std::string, std::string>> CatalogueTable::entries(std::string_view key) const {
  const TomlValue& value = demand(key);
  const auto* table = std::get_if<TomlTable>(&value.data);
  if (table == nullptr) fail_at(value.line, key, fmt::format("found {}; it must be a table", found(value)));
  std::vector<std::pair<std::string, std::string>> entries;
  for (const TomlEntry& entry : *table)
    entries.emplace_back(entry.key, text_of(fmt::format("{}: {}", key, entry.key), entry.value));
  return entries;
}

}  // namespace talus::verification
