#include "tests/interface/interface_text.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace talus::interface_audit {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string changed_number(const std::string& text, bool change) {
  if (!change) return text;
  const double value = std::strtod(text.c_str(), nullptr);
  return fmt::format("{}", value == 0.0 ? 0.01 : factor * value);
}

/// Length of the number at the start of a text; 0 if there is none.
std::size_t number_length(const std::string& text) {
  const std::size_t sign = !text.empty() && text.front() == '+' ? 1 : 0;
  double value{};
  const auto [end, failure] = std::from_chars(text.data() + sign, text.data() + text.size(), value);
  return failure == std::errc{} ? static_cast<std::size_t>(end - text.data()) : 0;
}

std::string kind_of(const fs::path& file) {
  static const std::set<std::string> whole{"history.csv", "summary.json", "final_state.json", "plot.json",
                                           "sheet.json",  "profile.csv",  "checkpoint.json",  "impacts.csv"};
  const std::string name = file.filename().string();
  const std::size_t dot = name.find('.');
  return whole.contains(name) || dot == std::string::npos ? name : "*" + name.substr(dot);
}

// --- TOML: the text is changed in place, so that lines and comments stay as they are ---------------------------------

/// A value of a TOML text: its item, its bytes, those of its key with it, and what it becomes.
struct Value {
  std::string item;
  std::size_t begin{}, end{};
  std::string changed;
};

class TomlValues {
 public:
  explicit TomlValues(const std::string& text) : text_{text} {
    starts_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') starts_.push_back(i + 1);
    visit(toml::parse(text), "field ");
  }
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }

 private:
  [[nodiscard]] std::size_t offset(toml::source_position at) const { return starts_.at(at.line - 1) + at.column - 1; }

  void visit(const toml::table& table, const std::string& path) {
    for (const auto& [key, node] : table)
      visit(node, path + std::string{key.str()}, &key);
  }

  void visit(const toml::node& node, const std::string& path, const toml::key* key) {
    if (const toml::table* const table = node.as_table()) {
      visit(*table, path + ".");
    } else if (const toml::array* const array = node.as_array()) {
      std::size_t index = 0;
      for (const toml::node& element : *array)
        visit(element, element.is_table() || element.is_array() ? path : fmt::format("{}.{}", path, index++), nullptr);
    } else {
      leaf(node, path, key);
    }
  }

  void leaf(const toml::node& node, const std::string& path, const toml::key* key) {
    Value value{path, offset(node.source().begin), offset(node.source().end), ""};
    const std::string text = text_.substr(value.begin, value.end - value.begin);
    if (const auto whole = node.value_exact<std::int64_t>()) {
      value.changed = fmt::format("{}", *whole + 1);
    } else if (node.is_floating_point()) {
      value.changed = changed_number(text, true);
      if (value.changed.find_first_of(".e") == std::string::npos) value.changed += ".0";
    } else if (const auto flag = node.value_exact<bool>()) {
      value.changed = *flag ? "false" : "true";
    } else if (const std::size_t length = number_length(text.substr(1)); length > 0) {
      value.changed = text.front() + changed_number(text.substr(1, length), true) + text.substr(1 + length);
    } else {
      if (key != nullptr) value.begin = offset(key->source().begin);
      remove(value);
    }
    values_.push_back(std::move(value));
  }

  /// Within braces and brackets a comma belongs to the text.
  void remove(Value& value) const {
    const std::size_t next = text_.find_first_not_of(' ', value.end);
    if (next != std::string::npos && text_[next] == ',') {
      value.end = next + 1;
      return;
    }
    const std::size_t before = text_.find_last_not_of(' ', value.begin - 1);
    if (value.begin > 0 && before != std::string::npos && text_[before] == ',') value.begin = before;
  }

  const std::string& text_;
  std::vector<std::size_t> starts_;
  std::vector<Value> values_;
};

// --- JSON ------------------------------------------------------------------------------------------------------------

/// Calls `leaf(path, value)` for each number, flag and text.
void visit(Json& json, const std::string& path, auto&& leaf) {
  if (json.is_object()) {
    for (auto& [key, value] : json.items())
      visit(value, path.ends_with(": ") ? path + key : path + "." + key, leaf);
  } else if (json.is_array()) {
    for (Json& element : json)
      visit(element, path + "[]", leaf);
  } else if (!json.is_null()) {
    leaf(path, json);
  }
}

void change(Json& json) {
  if (json.is_boolean()) {
    json = !json.get<bool>();
  } else if (json.is_number_integer()) {
    json = json.get<std::int64_t>() + 1;
  } else if (json.is_number()) {
    json = json.get<double>() == 0.0 ? 0.01 : factor * json.get<double>();
  } else {
    json = json.get<std::string>() + "x";
  }
}

std::string json_text(const Json& json) { return json.dump(1) + "\n"; }

// --- CSV and VTK -----------------------------------------------------------------------------------------------------

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  bool quoted = false;
  for (const char letter : line) {
    if (letter == '"') quoted = !quoted;
    if (letter == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += letter;
    }
  }
  return cells;
}

std::string without_quotes(const std::string& cell) {
  return cell.size() > 1 && cell.front() == '"' ? cell.substr(1, cell.size() - 2) : cell;
}

/// Position of the header, after lines that begin with #, in a CSV text.
std::size_t header_begin(const std::string& text) {
  std::size_t at = 0;
  while (at < text.size() && text[at] == '#')
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return at;
}
std::vector<std::string> header_of(const std::string& text) {
  const std::size_t at = header_begin(text);
  return cells_of(text.substr(at, text.find('\n', at) - at));
}

/// Item of a column. Columns of histories that are named after bodies and elements are one item each quantity.
std::string item_of_column(const std::string& kind, const std::string& cell) {
  static const std::set<std::string> sums{"energy", "dissipated", "balance_error"};
  std::string name = without_quotes(cell);
  const std::size_t dot = name.substr(0, name.find(" [")).rfind('.');
  if (kind.ends_with("history.csv") && dot != std::string::npos && !sums.contains(name.substr(0, dot)))
    name.replace(0, dot, "*");
  return "column " + kind + ": " + name;
}

/// The CSV text with the numbers and texts of one column changed; nothing if all its cells are empty.
std::optional<std::string> changed_column(const std::string& text, std::size_t column) {
  const std::size_t header = header_begin(text);
  std::istringstream lines(text.substr(header));
  std::string line, result = text.substr(0, header);
  bool any = false;
  for (std::size_t number = 0; std::getline(lines, line); ++number) {
    std::vector<std::string> cells = cells_of(line);
    if (number > 0 && column < cells.size() && !cells[column].empty()) {
      std::string& cell = cells[column];
      if (number_length(cell) == cell.size()) {
        cell = changed_number(cell, true);
      } else {
        cell.insert(cell.ends_with('"') ? cell.size() - 1 : cell.size(), "x");
      }
      any = true;
    }
    for (std::size_t i = 0; i < cells.size(); ++i)
      result += (i == 0 ? "" : ",") + cells[i];
    result += '\n';
  }
  return any ? std::optional{result} : std::nullopt;
}

/// Position of the numbers of each data array of a VTK text.
struct DataArray {
  std::string name;
  std::size_t begin{}, end{};
};

std::vector<DataArray> data_arrays(const std::string& text) {
  std::vector<DataArray> arrays;
  for (std::size_t at = text.find("<DataArray"); at != std::string::npos; at = text.find("<DataArray", at + 1)) {
    const std::size_t head = text.find('>', at), name = text.find("Name=\"", at);
    const std::size_t end = text.find("</DataArray>", at);
    if (head == std::string::npos || end == std::string::npos || text[head - 1] == '/') continue;
    arrays.push_back(
        {name < head ? text.substr(name + 6, text.find('"', name + 6) - name - 6) : "points", head + 1, end});
  }
  return arrays;
}

std::string changed_numbers(const std::string& text) {
  std::istringstream tokens(text);
  std::string result;
  for (std::string word; tokens >> word;)
    result += changed_number(word, true) + " ";
  return result;
}

}  // namespace

std::set<std::string> items_of(const fs::path& file, const std::string& text) {
  std::set<std::string> items;
  const std::string kind = kind_of(file), type = file.extension().string();
  try {
    if (type == ".toml") {
      const TomlValues toml(text);
      for (const Value& value : toml.values())
        items.insert(value.item);
    } else if (type == ".json") {
      Json json = Json::parse(text);
      visit(json, "member " + kind + ": ", [&](const std::string& path, Json&) { items.insert(path); });
    } else if (type == ".csv") {
      for (const std::string& cell : header_of(text))
        items.insert(item_of_column(kind, cell));
    } else if (type == ".vtp" || type == ".vtu") {
      for (const DataArray& array : data_arrays(text))
        items.insert("array " + kind + ": " + array.name);
    }
  } catch (const toml::parse_error&) {
  } catch (const nlohmann::json::exception&) {
  }
  return items;
}

std::optional<std::string> changed(const fs::path& file, const std::string& text, const std::string& item) {
  const std::string type = file.extension().string();
  static const std::map<std::string, std::string> kinds{
      {".toml", "field "}, {".json", "member "}, {".csv", "column "}, {".vtp", "array "}, {".vtu", "array "}};
  const auto kind = kinds.find(type);
  // Most items are of other files, which need not be parsed.
  if (kind == kinds.end() || !item.starts_with(kind->second + (type == ".toml" ? "" : kind_of(file) + ": ")))
    return std::nullopt;
  if (!items_of(file, text).contains(item)) return std::nullopt;
  if (type == ".toml") {
    std::string result = text;
    const std::vector<Value> values = TomlValues(text).values();
    std::vector<Value> wanted;
    for (const Value& value : values)
      if (value.item == item) wanted.push_back(value);
    // From the end, so that positions before stay as they are.
    std::sort(wanted.begin(), wanted.end(), [](const Value& a, const Value& b) { return a.begin > b.begin; });
    for (const Value& value : wanted)
      result.replace(value.begin, value.end - value.begin, value.changed);
    return result;
  }
  if (type == ".json") {
    Json json = Json::parse(text);
    visit(json, "member " + kind_of(file) + ": ", [&](const std::string& path, Json& leaf) {
      if (path == item) change(leaf);
    });
    return json_text(json);
  }
  if (type == ".csv") {
    const std::vector<std::string> cells = header_of(text);
    for (std::size_t i = cells.size(); i-- > 0;) {
      if (item_of_column(kind_of(file), cells[i]) == item) return changed_column(text, i);
    }
    return std::nullopt;
  }
  std::string result = text;
  const std::vector<DataArray> arrays = data_arrays(text);
  for (auto array = arrays.rbegin(); array != arrays.rend(); ++array) {
    if ("array " + kind_of(file) + ": " + array->name == item)
      result.replace(array->begin, array->end - array->begin,
                     changed_numbers(text.substr(array->begin, array->end - array->begin)));
  }
  return result;
}

std::optional<std::string> rewritten(const fs::path& file, const std::string& text) {
  if (file.extension() != ".json" || items_of(file, text).empty()) return std::nullopt;
  return json_text(Json::parse(text));
}

}  // namespace talus::interface_audit
