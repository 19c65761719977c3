#include "solver/io/catalogue_entry.hpp"

#include <algorithm>
#include <limits>

#include "solver/base/error.hpp"
#include "solver/base/units.hpp"

namespace talus::catalogue {

std::string text_of(double value) {
  return value == std::numeric_limits<double>::max() ? "no limit" : fmt::format("{}", value);
}

CatalogueField on_or_off(std::string name, std::string meaning, std::string absent) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .form = Form::name,
          .names = {"on", "off"},
          .absent = std::move(absent)};
}

CatalogueField table(std::string name, std::string meaning, Form form) {
  return {.name = std::move(name), .meaning = std::move(meaning), .form = form};
}

CatalogueField text(std::string name, std::string meaning) {
  return {.name = std::move(name), .meaning = std::move(meaning), .form = Form::text};
}

CatalogueField required(CatalogueField field, std::string condition) {
  field.required = true;
  field.absent.clear();
  field.condition = std::move(condition);
  return field;
}

CatalogueField vector(std::string name, std::string meaning, Dimension dimension, std::string absent) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .form = Form::vector,
          .dimension = dimension,
          .absent = std::move(absent)};
}

CatalogueField quantity(std::string name, std::string meaning, Dimension dimension, Range range, std::string absent) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .dimension = dimension,
          .range = range == Range::any ? "" : std::string{text_of(range)},
          .absent = std::move(absent)};
}

CatalogueField pairs(std::string name, std::string meaning, Dimension first, Dimension second) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .form = Form::pairs,
          .dimension = first,
          .second = second};
}

CatalogueField& field_of(Group& group, std::string_view name) {
  const auto found = std::ranges::find(group.fields, name, &CatalogueField::name);
  TALUS_DEMAND(found != group.fields.end());
  return *found;
}

void set_absent(Group& group, std::string_view name, std::string absent) {
  CatalogueField& field = field_of(group, name);
  field.required = false;
  field.absent = std::move(absent);
}

void set_required(Group& group, std::string_view name, std::string condition) {
  CatalogueField& field = field_of(group, name);
  field = required(std::move(field), std::move(condition));
}

void set_either(Group& group, std::string_view name, std::string_view other) {
  for (const auto& [one, alternative] : {std::pair{name, other}, std::pair{other, name}}) {
    set_required(group, one, "");
    field_of(group, one).alternative = alternative;
  }
}

void set_with(Group& group, std::string_view name, std::string with, std::string value) {
  CatalogueField& field = field_of(group, name);
  field.with = std::move(with);
  field.with_value = std::move(value);
}

void require_with(Group& group, std::string_view name, std::string with, std::string value) {
  field_of(group, name).required = true;
  set_with(group, name, std::move(with), std::move(value));
}

CatalogueField units_field() {
  return required({.name = "units",
                   .meaning = "unit system of the results; quantities in the file may have any units",
                   .form = Form::name,
                   .names = unit_system_names()});
}

CatalogueField integrator_field(std::vector<std::string> names, std::string absent) {
  return {.name = "integrator",
          .meaning = "method of time integration (talus list integrators)",
          .form = Form::name,
          .names = std::move(names),
          .absent = std::move(absent)};
}

Group watch_group(std::string id, std::string head, const MonitorRules& absent) {
  Group group{.id = std::move(id),
              .head = std::move(head),
              .about =
                  "what the run monitor does when it finds a limit exceeded; \"off\" in place of the table: "
                  "nothing"};
  for (const MonitorRules::Choice& watched : MonitorRules::choices()) {
    group.fields.push_back(choice(std::string{watched.name}, std::string{watched.meaning}, absent.*watched.member));
  }
  return group;
}

}  // namespace talus::catalogue
