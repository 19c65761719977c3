#include "solver/io/scene/scene_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "verification/record/utf8.hpp"

namespace talus {
namespace {

/// Replaces a wrong or missing number until the error is reported: allowed by all ranges.
constexpr double placeholder = 1.0;

/// Reason why a name cannot be used in the column headers of a history; empty if it can.
std::string_view refusal_reason(std::string_view name) {
  for (const std::string_view taken : {"time", "energy", "dissipated", "balance_error"}) {
    if (name == taken) return "a history has columns of that name; choose another";
  }
  if (name.find_first_of(",\"[]\t") != std::string_view::npos || records::shown_text(name) != name)
    return "a name heads columns of a CSV file; it must be without commas, quotes, brackets and control characters";
  return "";
}

}  // namespace

void SceneSource::add(int line, std::string message) const {
  errors_.push_back({line, std::move(message)});
  if (errors_.size() >= maximum_errors) check();
}

bool SceneSource::has_nameless(std::string_view kind) const {
  const std::string all = fmt::format(": {}: ", kind), one = fmt::format(": {} ", kind);
  return std::any_of(errors_.begin(), errors_.end(), [&](const Error& error) {
    const std::string_view message = error.message;
    const std::size_t at = message.find(one);
    return message.find(all) != std::string_view::npos ||
           (at != std::string_view::npos && message.substr(at + one.size(), 1) != "'");
  });
}

void SceneSource::check() const {
  collects_ = false;
  if (errors_.empty()) return;
  std::stable_sort(errors_.begin(), errors_.end(), [](const Error& a, const Error& b) { return a.line < b.line; });
  std::string all;
  for (const Error& error : errors_)
    all += (all.empty() ? "" : "\n") + error.message;
  if (errors_.size() >= maximum_errors)
    all += fmt::format("\n{}: there may be more errors; these are the first found", file);
  throw InputError{all};
}

SceneTable::SceneTable(const SceneSource& source, const TomlValue& value, std::string noun)
    : source_{&source}, table_{std::get_if<TomlTable>(&value.data)}, line_{value.line}, noun_{std::move(noun)} {
  TALUS_DEMAND(table_ != nullptr);
}

const TomlValue* SceneTable::find(std::string_view key) const {
  for (const auto& [name, value] : *table_) {
    if (name == key) return &value;
  }
  return nullptr;
}

bool SceneTable::has(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return find(key) != nullptr;
}

const TomlValue* SceneTable::value(std::string_view key) { return has(key) ? find(key) : nullptr; }

bool SceneTable::is_text(std::string_view key) const {
  const TomlValue* const value = find(key);
  return value != nullptr && std::holds_alternative<std::string>(value->data);
}

const TomlValue* SceneTable::demand(std::string_view key) {
  if (has(key)) return find(key);
  if (!is_misspelt(key)) report_at(line_, key, "it is missing");
  return nullptr;
}

const TomlValue& SceneTable::demand_at_once(std::string_view key) {
  const TomlValue* const value = demand(key);
  if (value == nullptr) throw SceneSource::Collected{full_message(line_, key, "it is missing")};
  return *value;
}

std::string SceneTable::location(int line) const {
  // A document that was not read from a text has no lines.
  return line > 0 ? fmt::format("{}:{}: ", source_->file, line) : source_->file + ": ";
}

std::string SceneTable::full_message(int line, std::string_view key, std::string_view message) const {
  const std::string noun = noun_.empty() ? "" : noun_ + ": ";
  // Keys, names and values are texts of the file.
  return location(line) + records::shown_text(fmt::format("{}{}: {}", noun, key, message));
}

void SceneTable::report_at(int line, std::string_view key, std::string_view message) const {
  if (!source_->collects()) throw InputError{full_message(line, key, message)};
  source_->add(line, full_message(line, key, message));
}

void SceneTable::fail_at(int line, std::string_view key, std::string_view message) const {
  report_at(line, key, message);
  throw SceneSource::Collected{full_message(line, key, message)};
}

void SceneTable::fail(std::string_view key, std::string_view message) const {
  const TomlValue* value = find(key);
  fail_at(value != nullptr ? value->line : line_, key, message);
}

void SceneTable::report(std::string_view key, std::string_view message) const {
  const TomlValue* value = find(key);
  report_at(value != nullptr ? value->line : line_, key, message);
}

double SceneTable::quantity_of(std::string_view key, const TomlValue& value, Dimension dimension, Range range) const {
  if (dimension == dimension::number) return number_of(key, value, range);
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) {
    const bool bare = std::holds_alternative<double>(value.data) || std::holds_alternative<std::int64_t>(value.data);
    const std::string example = fmt::format("\"{} {}\"", bare ? found(value) : "1", symbol(source_->units, dimension));
    report_at(value.line, key,
              bare ? fmt::format("found {}; the unit is missing; write e.g. {}", found(value), example)
                   : fmt::format("found {}; it must be a quantity in quotes, e.g. {}", found(value), example));
    return placeholder;
  }
  std::string wrong;
  try {
    const double quantity = parse_quantity(*text, dimension, source_->units);
    if (contains(range, quantity)) return quantity;
    wrong = fmt::format("found \"{}\"; it must be {}", *text, text_of(range));
  } catch (const InputError& error) {
    wrong = error.what();
  }
  report_at(value.line, key, wrong);
  return placeholder;
}

double SceneTable::quantity(std::string_view key, Dimension dimension, Range range) {
  const TomlValue* const value = demand(key);
  return value == nullptr ? placeholder : quantity_of(key, *value, dimension, range);
}

double SceneTable::quantity_or(std::string_view key, Dimension dimension, double absent, Range range) {
  return has(key) ? quantity(key, dimension, range) : absent;
}

std::vector<double> SceneTable::quantities(std::string_view key, Dimension dimension, std::size_t minimum,
                                           std::size_t maximum) {
  constexpr std::string_view axes = "xyz";
  TALUS_DEMAND(maximum <= axes.size());
  const TomlValue* const given = demand(key);
  if (given == nullptr) return std::vector<double>(minimum);
  const TomlValue& value = *given;
  const auto* elements = std::get_if<TomlArray>(&value.data);
  const std::string count = minimum == maximum ? fmt::format("{}", minimum) : fmt::format("{} or {}", minimum, maximum);
  if (elements == nullptr) {
    const std::string example = fmt::format("\"1 {}\"", symbol(source_->units, dimension));
    const std::vector<std::string> examples(minimum, example);
    report_at(value.line, key,
              fmt::format("found {}; it must be an array of {} quantities, e.g. [{}]", found(value), count,
                          fmt::join(examples, ", ")));
    return std::vector<double>(minimum);
  }
  if (elements->size() < minimum || elements->size() > maximum) {
    report_at(value.line, key, fmt::format("found {} components; it must have {}", elements->size(), count));
    return std::vector<double>(minimum);
  }
  std::vector<double> result;
  for (std::size_t i = 0; i < elements->size(); ++i) {
    result.push_back(quantity_of(fmt::format("{}.{}", key, axes[i]), (*elements)[i], dimension, Range::any));
  }
  return result;
}

std::optional<std::array<double, 2>> SceneTable::two_quantities(std::string_view key, Dimension dimension) {
  const TomlValue* const value = demand(key);
  if (value == nullptr) return {};
  const auto* const ends = std::get_if<TomlArray>(&value->data);
  if (ends == nullptr || ends->size() != 2) {
    report_at(value->line, key,
              fmt::format("found {0}; it must be an array of 2 quantities, e.g. [\"1 {1}\", \"2 {1}\"]", found(*value),
                          symbol(source_->units, dimension)));
    return {};
  }
  const std::size_t errors = source_->errors();
  std::array<double, 2> read{};
  for (std::size_t i = 0; i < 2; ++i)
    read[i] = quantity_of(fmt::format("{}[{}]", key, i), (*ends)[i], dimension, Range::any);
  if (source_->errors() > errors) return {};
  return read;
}

std::vector<double> SceneTable::quantities_or_one(std::string_view key, Dimension dimension, Range range) {
  const TomlValue* const value = demand(key);
  if (value == nullptr) return {};
  const auto* const elements = std::get_if<TomlArray>(&value->data);
  if (elements == nullptr) return {quantity_of(key, *value, dimension, range)};
  if (elements->empty()) report_at(value->line, key, "found []; it must have a quantity");
  std::vector<double> result;
  for (std::size_t i = 0; i < elements->size(); ++i)
    result.push_back(quantity_of(fmt::format("{}[{}]", key, i), (*elements)[i], dimension, range));
  return result;
}

Vec2 SceneTable::vector(std::string_view key, Dimension dimension) {
  const std::vector<double> components = quantities(key, dimension, 2, 2);
  return {components[0], components[1]};
}

Vec2 SceneTable::vector_or(std::string_view key, Dimension dimension, Vec2 absent) {
  return has(key) ? vector(key, dimension) : absent;
}

double SceneTable::number(std::string_view key, Range range) {
  const TomlValue* const value = demand(key);
  return value == nullptr ? placeholder : number_of(key, *value, range);
}

double SceneTable::number_of(std::string_view key, const TomlValue& value, Range range) const {
  double number = 0.0;
  if (const auto* real = std::get_if<double>(&value.data)) {
    number = *real;
  } else if (const auto* integer = std::get_if<std::int64_t>(&value.data)) {
    number = static_cast<double>(*integer);
  } else {
    report_at(value.line, key,
              fmt::format("found {}; it must be a pure number without quotes, e.g. 0.5", found(value)));
    return placeholder;
  }
  if (std::isfinite(number) && contains(range, number)) return number;
  report_at(value.line, key, fmt::format("found {}; it must be {}", found(value), text_of(range)));
  return placeholder;
}

int SceneTable::whole(std::string_view key) { return whole_of(key, demand_at_once(key)); }

std::int64_t SceneTable::whole_between(std::string_view key, std::int64_t minimum, std::int64_t maximum) {
  const TomlValue* const given = demand(key);
  if (given == nullptr) return minimum;
  const TomlValue& value = *given;
  const auto* integer = std::get_if<std::int64_t>(&value.data);
  if (integer != nullptr && *integer >= minimum && *integer <= maximum) return *integer;
  const std::string allowed = maximum - minimum == 1
                                  ? fmt::format("{} or {}", minimum, maximum)
                                  : fmt::format("a whole number between {} and {}", minimum, maximum);
  report_at(value.line, key, fmt::format("found {}; it must be {}", found(value), allowed));
  return minimum;
}

int SceneTable::whole_of(std::string_view key, const TomlValue& value) const {
  constexpr std::int64_t maximum = 1'000'000'000;
  const auto* integer = std::get_if<std::int64_t>(&value.data);
  if (integer == nullptr)
    fail_at(value.line, key, fmt::format("found {}; it must be a whole number, e.g. 12", found(value)));
  if (*integer < -maximum || *integer > maximum)
    fail_at(value.line, key, fmt::format("found {}; it must be between {} and {}", *integer, -maximum, maximum));
  return static_cast<int>(*integer);
}

std::vector<int> SceneTable::wholes_or_one(std::string_view key) {
  const TomlValue& value = demand_at_once(key);
  if (!std::holds_alternative<TomlArray>(value.data)) return {whole_of(key, value)};
  std::vector<int> result = wholes(key);
  if (result.empty()) fail_at(value.line, key, "found no number; give one");
  return result;
}

std::vector<std::array<double, 2>> SceneTable::pairs(std::string_view key, Dimension first, Dimension second) {
  const TomlValue& value = demand_at_once(key);
  const auto one = [&](Dimension dimension) {
    return dimension == dimension::number ? "1.0" : fmt::format("\"1 {}\"", symbol(source_->units, dimension));
  };
  const std::string example = fmt::format("[{}, {}]", one(first), one(second));
  const auto* points = std::get_if<TomlArray>(&value.data);
  if (points == nullptr) fail_at(value.line, key, fmt::format("found {}; it must be [{}, ...]", found(value), example));
  std::vector<std::array<double, 2>> result;
  for (const TomlValue& point : *points) {
    const auto* pair = std::get_if<TomlArray>(&point.data);
    if (pair == nullptr || pair->size() != 2) {
      fail_at(point.line, key, fmt::format("found {}; each point must be a pair, e.g. {}", found(point), example));
    }
    result.push_back(
        {quantity_of(key, (*pair)[0], first, Range::any), quantity_of(key, (*pair)[1], second, Range::any)});
  }
  return result;
}

std::vector<int> SceneTable::wholes(std::string_view key) {
  const TomlValue& value = demand_at_once(key);
  const auto* elements = std::get_if<TomlArray>(&value.data);
  if (elements == nullptr) {
    fail_at(value.line, key, fmt::format("found {}; it must be an array of whole numbers, e.g. [1, 2]", found(value)));
  }
  std::vector<int> result;
  for (const TomlValue& element : *elements)
    result.push_back(whole_of(key, element));
  return result;
}

std::string SceneTable::written(std::string_view key) const {
  const TomlValue* const value = find(key);
  const auto* text = value != nullptr ? std::get_if<std::string>(&value->data) : nullptr;
  return text != nullptr ? *text : std::string{};
}

std::string SceneTable::text_called(std::string_view key, std::string_view what) {
  const TomlValue& value = demand_at_once(key);
  const auto* text = std::get_if<std::string>(&value.data);
  if (text != nullptr && !text->empty()) return *text;
  fail_at(value.line, key, fmt::format("found {}; it must be {}", found(value), what));
}

std::string SceneTable::text(std::string_view key) { return text_called(key, "a text in quotes"); }

std::string SceneTable::file_name(std::string_view key) { return text_called(key, "the name of a file, in quotes"); }

std::string SceneTable::title() {
  constexpr std::string_view key = "title";
  if (!has(key)) return {};
  const TomlValue* const value = find(key);
  const auto* const given = value != nullptr ? std::get_if<std::string>(&value->data) : nullptr;
  return given != nullptr && given->empty() ? std::string{} : text(key);
}

std::vector<std::string> SceneTable::texts(std::string_view key, std::size_t count) {
  const TomlValue& value = demand_at_once(key);
  std::vector<std::string> result;
  if (const auto* elements = std::get_if<TomlArray>(&value.data)) {
    for (const TomlValue& element : *elements) {
      if (const auto* text = std::get_if<std::string>(&element.data)) result.push_back(*text);
    }
    if (elements->size() == count && result.size() == count) return result;
  }
  fail_at(value.line, key, fmt::format("found {}; it must be an array of {} texts in quotes", found(value), count));
}

std::string SceneTable::choice(std::string_view key, const std::vector<std::string>& known) {
  std::string name = text(key);
  if (std::find(known.begin(), known.end(), name) != known.end()) return name;
  fail(key,
       fmt::format("found \"{}\"; nearest: {}; known: {}", name, nearest_name(name, known), fmt::join(known, ", ")));
}

bool SceneTable::on_or_off(std::string_view key, bool absent) {
  bool is_on = absent;
  if (has(key)) guard([&] { is_on = choice(key, {"on", "off"}) == "on"; });
  return is_on;
}

std::vector<std::string> SceneTable::choices(std::string_view key, const std::vector<std::string>& known) {
  const TomlValue& value = demand_at_once(key);
  std::vector<std::string> result;
  const auto* elements = std::get_if<TomlArray>(&value.data);
  for (std::size_t i = 0; elements != nullptr && i < elements->size(); ++i) {
    const auto* text = std::get_if<std::string>(&(*elements)[i].data);
    if (text == nullptr || std::find(known.begin(), known.end(), *text) == known.end()) {
      fail_at((*elements)[i].line, key,
              fmt::format("found {}; known: {}", found((*elements)[i]), fmt::join(known, ", ")));
    }
    result.push_back(*text);
  }
  if (elements != nullptr) return result;
  fail_at(value.line, key,
          fmt::format("found {}; it must be an array of names out of: {}", found(value), fmt::join(known, ", ")));
}

SceneTable SceneTable::table(std::string_view key) {
  const TomlValue& value = demand_at_once(key);
  if (!std::holds_alternative<TomlTable>(value.data)) {
    const auto* const tables = std::get_if<TomlArray>(&value.data);
    const bool headed_twice = noun_.empty() && tables != nullptr && !tables->empty() &&
                              std::holds_alternative<TomlTable>(tables->front().data);
    fail_at(value.line, key,
            fmt::format("found {}; it must be a table{}", found(value),
                        headed_twice ? fmt::format(", headed [{}] in place of [[{}]]", key, key) : ""));
  }
  return {*source_, value, noun_.empty() ? std::string{key} : fmt::format("{}: {}", noun_, key)};
}

std::vector<SceneTable> SceneTable::numbered_tables(std::string_view key) {
  std::vector<SceneTable> result;
  if (!has(key)) return result;
  const TomlValue& value = *find(key);
  const auto* elements = std::get_if<TomlArray>(&value.data);
  const auto is_table = [](const TomlValue& element) { return std::holds_alternative<TomlTable>(element.data); };
  if (elements == nullptr || !std::all_of(elements->begin(), elements->end(), is_table)) {
    report_at(value.line, key,
              fmt::format("found {}; each {} is a separate table, headed [[{}]]", found(value), key, key));
    return result;
  }
  const std::string of = noun_.empty() ? "" : noun_ + ": ";
  for (const TomlValue& element : *elements)
    result.emplace_back(*source_, element, fmt::format("{}{} {}", of, key, result.size() + 1));
  return result;
}

std::vector<SceneTable> SceneTable::tables(std::string_view key) {
  std::vector<SceneTable> result;
  for (SceneTable& table : numbered_tables(key)) {
    source_->guard(table.line_, [&] {
      const std::string name = table.text("name");
      if (const std::string_view why = refusal_reason(name); !why.empty()) {
        table.fail("name", fmt::format("found \"{}\"; {}", name, why));
      }
      table.noun_ = fmt::format("{} '{}'", key, name);
      result.push_back(std::move(table));
    });
  }
  return result;
}

bool SceneTable::is_misspelt(std::string_view key) const {
  return std::find(misspelt_.begin(), misspelt_.end(), key) != misspelt_.end();
}

void SceneTable::refuse(std::string_view key, std::string_view why) {
  if (find(key) != nullptr) report(key, why);
}

void SceneTable::allow(std::vector<std::string> keys) {
  for (std::string& key : keys) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(std::move(key));
  }
  for (const auto& [name, value] : *table_) {
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    misspelt_.push_back(nearest_name(name, known_));
    report_at(value.line, name,
              fmt::format("this key is not known; nearest: {}; known: {}", misspelt_.back(), fmt::join(known_, ", ")));
  }
}

}  // namespace talus
