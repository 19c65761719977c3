#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/io/catalogue_field.hpp"
#include "solver/run/run_plan.hpp"

/// Entries of the field catalogue: fields of each form, and changes of fields that a group has from the lists of the
/// readers.
namespace talus::catalogue {

using Form = FieldForm;
using Group = FieldGroup;

/// The number as text, or "no limit".
[[nodiscard]] std::string text_of(double value);

/// Field whose value is one of the names of an enum; `absent` is the default.
template <class Enum>
CatalogueField choice(std::string name, std::string meaning, Enum absent) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .form = Form::name,
          .names = names_of<Enum>(),
          .absent = std::string{name_of(absent)}};
}

[[nodiscard]] CatalogueField on_or_off(std::string name, std::string meaning, std::string absent);
[[nodiscard]] CatalogueField table(std::string name, std::string meaning, Form form = Form::table);
[[nodiscard]] CatalogueField text(std::string name, std::string meaning);
[[nodiscard]] CatalogueField required(CatalogueField field, std::string condition = {});
[[nodiscard]] CatalogueField vector(std::string name, std::string meaning, Dimension dimension, std::string absent);
[[nodiscard]] CatalogueField quantity(std::string name, std::string meaning, Dimension dimension, Range range,
                                      std::string absent);
[[nodiscard]] CatalogueField pairs(std::string name, std::string meaning, Dimension first, Dimension second);

/// Adds the fields of T as SceneTable::read_fields() reads them: a field whose value in `usual` is allowed is optional.
template <class T>
void add_fields(Group& group, const T& usual = {}) {
  for (const auto& field : T::fields()) {
    const double value = usual.*field.member;
    CatalogueField made = quantity(std::string{field.name}, std::string{field.meaning}, field.dimension, field.range,
                                   contains(field.range, value) ? text_of(value) : "");
    made.required = !contains(field.range, value);
    group.fields.push_back(std::move(made));
  }
}

/// Adds the counts of T; all are required until set_absent() makes them optional.
template <class T>
void add_counts(Group& group) {
  for (const auto& field : T::counts()) {
    group.fields.push_back({.name = std::string{field.name},
                            .meaning = std::string{field.meaning},
                            .form = Form::whole,
                            .range = fmt::format("{} .. {}", field.minimum, field.maximum),
                            .required = true});
  }
}

/// The field of this name, which must already be in the group.
[[nodiscard]] CatalogueField& field_of(Group& group, std::string_view name);

/// Makes a field optional with the default `absent`.
void set_absent(Group& group, std::string_view name, std::string absent);
void set_required(Group& group, std::string_view name, std::string condition);

/// Makes two fields alternatives of which one is required.
void set_either(Group& group, std::string_view name, std::string_view other);
void set_with(Group& group, std::string_view name, std::string with, std::string value = {});
/// Makes a field required if the field `with` is given; otherwise it may be omitted.
void require_with(Group& group, std::string_view name, std::string with, std::string value = {});

[[nodiscard]] CatalogueField units_field();
[[nodiscard]] CatalogueField integrator_field(std::vector<std::string> names, std::string absent);
[[nodiscard]] Group watch_group(std::string id, std::string head, const MonitorRules& absent);

}  // namespace talus::catalogue
