#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/base/fields.hpp"
#include "solver/base/units.hpp"
#include "solver/base/vec.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus {

/// Data shared by all tables of one scene file, and the errors found in it so far.
class SceneSource {
 public:
  /// Maximum number of errors listed for one file.
  static constexpr std::size_t maximum_errors = 20;

  std::string file;  ///< as named in messages
  UnitSystem units;

  SceneSource(std::string name, UnitSystem system) : file{std::move(name)}, units{system} {}

  /// Collects the errors of single keys and tables from here on up to the next check(): a wrong or missing key gets a
  /// placeholder, a table that cannot be read is skipped.
  void collect() const { collects_ = true; }
  bool collects() const { return collects_; }
  /// Whether a table of this kind, e.g. "body", has an error that leaves its name unknown.
  bool has_nameless(std::string_view kind) const;
  /// Number of errors collected so far: a check of several values is left out if there is one of them.
  std::size_t errors() const { return errors_.size(); }
  /// Throws all errors collected so far, sorted by line, as one InputError with one line for each.
  void check() const;

  /// Adds an error; throws all errors if there are too many.
  void add(int line, std::string message) const;
  /// Calls `read`; adds an InputError that it throws for the given line, unless that error is already in the list.
  template <class Read>
  void guard(int line, Read&& read) const {
    if (!collects_) return void(read());
    try {
      read();
    } catch (const Collected&) {
      // It is already in the list.
    } catch (const InputError& error) {
      if (!collects_) throw;  // too many errors: this one contains all of them
      add(line, error.what());
    }
  }

  /// An error that is already in the list.
  class Collected : public InputError {
   public:
    using InputError::InputError;
  };

 private:
  struct Error {
    int line{};
    std::string message;
  };
  mutable bool collects_{false};
  mutable std::vector<Error> errors_;
};

/// One table of a scene file, read key by key. All errors are InputError of the form
/// `file.toml:17: body 'rock': mass: found "-3 kg"; it must be > 0`; see SceneSource for several errors. allow()
/// rejects keys that were neither read nor allowed. A reader calls it first, so that a misspelt key is one error: it is
/// not also reported as missing.
class SceneTable {
 public:
  /// `noun` names in messages what the table describes: "body 'rock'"; empty for the file itself. `value` must be a
  /// table.
  SceneTable(const SceneSource& source, const TomlValue& value, std::string noun);

  int line() const { return line_; }
  const SceneSource& source() const { return *source_; }
  const UnitSystem& units() const { return source_->units; }
  bool has(std::string_view key);
  /// Whether the key is present and its value is a text in quotes.
  bool is_text(std::string_view key) const;

  /// A quantity with its unit, in consistent units of the scene; without dimension, a pure number.
  [[nodiscard]] double quantity(std::string_view key, Dimension dimension, Range range = Range::any);
  [[nodiscard]] double quantity_or(std::string_view key, Dimension dimension, double absent, Range range = Range::any);
  /// An array of `minimum` to `maximum` quantities of one dimension.
  [[nodiscard]] std::vector<double> quantities(std::string_view key, Dimension dimension, std::size_t minimum,
                                               std::size_t maximum);
  /// The two ends of a range of quantities; nothing if an error of them was reported.
  [[nodiscard]] std::optional<std::array<double, 2>> two_quantities(std::string_view key, Dimension dimension);
  /// A quantity, or a non-empty array of them.
  [[nodiscard]] std::vector<double> quantities_or_one(std::string_view key, Dimension dimension,
                                                      Range range = Range::any);
  [[nodiscard]] Vec2 vector(std::string_view key, Dimension dimension);
  [[nodiscard]] Vec2 vector_or(std::string_view key, Dimension dimension, Vec2 absent);
  /// A pure number, written without quotes.
  [[nodiscard]] double number(std::string_view key, Range range = Range::any);
  /// A whole number.
  [[nodiscard]] int whole(std::string_view key);
  /// A whole number from `minimum` to `maximum`.
  [[nodiscard]] std::int64_t whole_between(std::string_view key, std::int64_t minimum, std::int64_t maximum);
  /// A whole number, or a non-empty array of whole numbers.
  [[nodiscard]] std::vector<int> wholes_or_one(std::string_view key);
  /// An array of pairs of quantities.
  [[nodiscard]] std::vector<std::array<double, 2>> pairs(std::string_view key, Dimension first, Dimension second);
  /// An array of whole numbers.
  [[nodiscard]] std::vector<int> wholes(std::string_view key);
  [[nodiscard]] std::string text(std::string_view key);
  /// A text that names a file.
  [[nodiscard]] std::string file_name(std::string_view key);
  /// The text of `title`; empty if there is none.
  [[nodiscard]] std::string title();
  [[nodiscard]] std::vector<std::string> texts(std::string_view key, std::size_t count);
  /// An array of names from a closed list.
  [[nodiscard]] std::vector<std::string> choices(std::string_view key, const std::vector<std::string>& known);
  /// One name from a closed list.
  [[nodiscard]] std::string choice(std::string_view key, const std::vector<std::string>& known);
  /// The enum value that the key names; `absent` if the key is missing or wrong.
  template <class Enum>
  [[nodiscard]] Enum choice_or(std::string_view key, Enum absent) {
    if (!has(key)) return absent;
    std::string name;
    source_->guard(line_, [&] { name = choice(key, names_of<Enum>()); });
    return find_named<Enum>(name).value_or(absent);
  }
  /// Whether the key is "on", which it must be unless it is "off"; `absent` if the key is missing or wrong.
  [[nodiscard]] bool on_or_off(std::string_view key, bool absent = false);
  /// Calls `read` for a part of the table on which reading the rest does not depend; see SceneSource::guard().
  template <class Read>
  void guard(Read&& read) const {
    source_->guard(line_, std::forward<Read>(read));
  }
  /// The value of a key as it is; null if the key is missing.
  [[nodiscard]] const TomlValue* value(std::string_view key);
  /// A table inside this one.
  [[nodiscard]] SceneTable table(std::string_view key);
  /// The tables of an array of tables, [[key]]; empty if the key is missing or wrong. Messages use each table's `name`.
  [[nodiscard]] std::vector<SceneTable> tables(std::string_view key);
  /// The same for tables without names; messages use their numbers from 1.
  [[nodiscard]] std::vector<SceneTable> numbered_tables(std::string_view key);

  /// Reads all fields of T; a field whose value before reading is allowed is optional.
  template <class T>
  void read_fields(T& value) {
    for (const auto& field : T::fields())
      read_field(value, field);
  }
  template <class T>
  void read_field(T& value, const Field<T>& field) {
    if (contains(field.range, value.*field.member) && !has(field.name)) return;
    value.*field.member = quantity(field.name, field.dimension, field.range);
  }
  /// Reads a whole number in the range of its field.
  template <class T>
  void read_count(T& value, const CountField<T>& field) {
    const auto count = static_cast<int>(whole_between(field.name, field.minimum, field.maximum));
    std::visit([&](auto member) { value.*member = count; }, field.member);
  }

  /// Whether allow() found an unknown key of which this one is the nearest known one: it is presumably not missing.
  [[nodiscard]] bool is_misspelt(std::string_view key) const;
  /// Reports an error if the key is present, with the reason why it is not allowed.
  void refuse(std::string_view key, std::string_view why);
  /// Reports all keys of the table except these and those requested so far, naming the nearest known one.
  void allow(std::vector<std::string> keys);

  /// The text of a key as written, without its quotes; empty if the key is missing or its value is not a text.
  [[nodiscard]] std::string written(std::string_view key) const;

  /// Throws an error about a key (or about the table itself, if it has no such key).
  [[noreturn]] void fail(std::string_view key, std::string_view message) const;
  /// Adds such an error to those of the source, or throws it if the source does not collect errors.
  void report(std::string_view key, std::string_view message) const;
  /// Calls `action`; prepends this table's file and line to an InputError that it throws.
  template <class Action>
  auto placed(Action&& action) const {
    try {
      return action();
    } catch (const InputError& error) {
      throw InputError{location(line_) + error.what()};
    }
  }

 private:
  const TomlValue* find(std::string_view key) const;
  /// The value of a key; null if it is missing, which is reported as an error.
  const TomlValue* demand(std::string_view key);
  /// The value of a key without which the table cannot be read; throws if it is missing.
  const TomlValue& demand_at_once(std::string_view key);
  /// A text that is not empty; messages call it `what`.
  std::string text_called(std::string_view key, std::string_view what);
  double number_of(std::string_view key, const TomlValue& value, Range range) const;
  double quantity_of(std::string_view key, const TomlValue& value, Dimension dimension, Range range) const;
  int whole_of(std::string_view key, const TomlValue& value) const;
  [[noreturn]] void fail_at(int line, std::string_view key, std::string_view message) const;
  void report_at(int line, std::string_view key, std::string_view message) const;
  std::string full_message(int line, std::string_view key, std::string_view message) const;
  std::string location(int line) const;

  const SceneSource* source_;
  const TomlTable* table_;
  int line_;
  std::string noun_;
  std::vector<std::string> known_;
  std::vector<std::string> misspelt_;  ///< known keys for which unknown ones were presumably meant
};

/// Names of the fields of T, as written in a scene.
template <class T>
std::vector<std::string> field_names() {
  std::vector<std::string> names;
  for (const auto& field : T::fields())
    names.emplace_back(field.name);
  return names;
}

}  // namespace talus
