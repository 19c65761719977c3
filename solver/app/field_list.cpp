#include "solver/app/field_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "solver/base/units.hpp"

namespace talus::app {
namespace {

constexpr std::size_t columns = 110, name_columns = 19;

/// Appends words to a text, wrapped at `columns`; all lines except the first are indented.
void append_wrapped(std::string& text, std::string_view added, std::size_t indent) {
  std::size_t used = text.size() - (text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
  bool first = true;
  while (!added.empty()) {
    const std::string_view word = added.substr(0, added.find(' '));
    added.remove_prefix(std::min(word.size() + 1, added.size()));
    if (!first && used + 1 + word.size() > columns) {
      text += '\n' + std::string(indent, ' ');
      used = indent;
    } else if (!first) {
      text += ' ';
      ++used;
    }
    text += word;
    used += word.size();
    first = false;
  }
  text += '\n';
}

std::string example(const UnitSystem& units, Dimension dimension) {
  return dimension == dimension::number ? "1.5" : fmt::format("\"1 {}\"", symbol(units, dimension));
}

/// Both texts, or one if they are equal.
std::string either(const std::string& of_si, const std::string& of_us) {
  return of_si == of_us ? of_si : fmt::format("{} or {}", of_si, of_us);
}

/// "a stiffness, e.g. "1 N/m" or "1 lbf/ft""; "a pure number".
std::string quantity_text(Dimension dimension) {
  if (dimension == dimension::number) return text_of(dimension);
  return fmt::format("{}, e.g. {}", text_of(dimension), either(example(si, dimension), example(us, dimension)));
}

std::string pair_text(const CatalogueField& field) {
  const auto pair = [&](const UnitSystem& units) {
    return fmt::format("[[{}, {}], ..]", example(units, field.dimension), example(units, field.second));
  };
  const std::string kinds = field.dimension == field.second
                                ? fmt::format("pairs, each value {}", text_of(field.dimension))
                                : fmt::format("pairs of {} and {}", text_of(field.dimension), text_of(field.second));
  return fmt::format("{}, e.g. {}", kinds, either(pair(si), pair(us)));
}

/// Notation of the field's value.
std::string form_text(const CatalogueField& field) {
  switch (field.form) {
    case FieldForm::quantity:
      return quantity_text(field.dimension);
    case FieldForm::vector:
      return "[x, y], each " + quantity_text(field.dimension);
    case FieldForm::point:
      return "[x, y] or [x, y, z], each " + quantity_text(field.dimension);
    case FieldForm::pairs:
      return pair_text(field);
    case FieldForm::whole:
      return "a whole number";
    case FieldForm::wholes:
      return "an array of whole numbers, e.g. [1, 2]";
    case FieldForm::one_or_two:
      return "a whole number, or two in an array, e.g. [12, 4]";
    case FieldForm::text:
      return "a text in quotes";
    case FieldForm::two_texts:
      return "an array of two texts, e.g. [\"rock\", \"ground\"]";
    case FieldForm::name:
      return fmt::format("{}", fmt::join(field.names, ", "));
    case FieldForm::names:
      return fmt::format("an array of any of: {}", fmt::join(field.names, ", "));
    case FieldForm::table:
      return "a table";
    case FieldForm::table_or_off:
      return "a table, or \"off\"";
    case FieldForm::tables:
      return "an array of tables, one for each";
    case FieldForm::time_or_auto:
      return quantity_text(field.dimension) + ", or \"auto\"";
  }
  return "";
}

/// Condition under which a field is required or allowed; empty if there is none.
std::string condition_text(const CatalogueField& field) {
  if (!field.alternative.empty()) return fmt::format("this or {}", field.alternative);
  std::string condition = field.condition;
  if (!field.with.empty()) {
    condition = field.with_value.empty() ? fmt::format("with {}", field.with)
                                         : fmt::format("with {} = {}", field.with, field.with_value);
  }
  if (condition.empty()) return "";
  return fmt::format("{} {}", field.required ? "required" : "only", condition);
}

std::string value_text(const CatalogueField& field) {
  std::string text = form_text(field);
  const auto add = [&](std::string_view added) {
    if (!added.empty()) text.append("; ").append(added);
  };
  add(field.range);
  add(condition_text(field));
  if (!field.absent.empty()) add("default: " + field.absent);
  return text;
}

}  // namespace

std::string field_list_legend() {
  return "* required; where a condition is given, only if it holds. A quantity may have any unit of its dimension.\n";
}

std::string field_list(const FieldGroup& group) {
  std::string text;
  std::string about = group.about;
  if (!group.base.empty())
    about += fmt::format("{}also the fields of {}", about.empty() ? "" : "; ", field_group(group.base).head);
  append_wrapped(text, fmt::format("{}: {}", group.head, about), 4);
  for (const CatalogueField& field : group.fields) {
    text += fmt::format("  {} {:<{}} ", field.required ? '*' : ' ', field.name, name_columns);
    append_wrapped(text, field.meaning, name_columns + 5);
    text += std::string(name_columns + 5, ' ');
    append_wrapped(text, value_text(field), name_columns + 5);
  }
  return text;
}

}  // namespace talus::app
