#include "solver/io/toml_fence.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/integrate/integrator_list.hpp"
#include "solver/io/fence_names.hpp"
#include "solver/io/fence_rules.hpp"
#include "solver/io/scene_parts.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus {
namespace {

using scenes::ElementType;
using scenes::Fence;
using scenes::FenceElement;

/// Names of all fields of T.
template <class T>
std::vector<std::string> keys() {
  std::vector<std::string> names = field_names<T>();
  for (const auto& field : T::counts())
    names.emplace_back(field.name);
  return names;
}

FenceElement read_element(SceneTable& table, ElementType type) {
  std::vector<std::string> known = keys<FenceElement>();
  for (const auto& field : FenceElement::vectors())
    known.emplace_back(field.name);
  known.insert(known.end(), {"solid", "held", "along"});
  table.allow(known);
  FenceElement element;
  element.type = type;
  static_cast<void>(table.text("solid"));
  element.solid = table.choice_or("solid", element.solid);
  table.read_fields(element);
  element.along = table.quantity_or("along", dimension::length, 0.0);
  for (const auto& field : FenceElement::counts())
    table.read_count(element, field);
  for (const auto& field : FenceElement::vectors())
    element.*field.member = table.vector_or(field.name, field.dimension, {});
  if (table.has("held")) {
    for (const std::string& axis : table.choices("held", {held_axes.begin(), held_axes.end()}))
      element.held[static_cast<std::size_t>(std::ranges::find(held_axes, axis) - held_axes.begin())] = true;
  }
  return element;
}

scenes::FenceOptions read_options(SceneTable table) {
  scenes::FenceOptions options;
  for_each_choice(options, [&](std::string_view name, auto& choice) { choice = table.choice_or(name, choice); });
  if (table.has("watch")) options.watch = read_watch(table.table("watch"));
  if (table.has("integrator")) options.integrator = table.choice("integrator", integrator_names());
  table.read_fields(options);
  if (table.has("table")) {
    for (const auto& [strain, multiple] : table.pairs("table", dimension::number, dimension::number))
      options.table.push_back({strain, multiple});
  }
  table.allow(field_names<scenes::FenceOptions>());
  return options;
}

/// A changed column: what its table leaves out is as with the others.
scenes::ChangedColumn read_changed(SceneTable& table, const Fence& fence) {
  table.allow(keys<scenes::ChangedColumn>());
  const FenceElement& pattern = fence.column;
  scenes::ChangedColumn column{1, pattern.a, pattern.b, pattern.density, fence.y_top, fence.y_bottom};
  table.read_fields(column);
  for (const auto& field : scenes::ChangedColumn::counts())
    table.read_count(column, field);
  if (const int most = columns_of_half(fence); column.place > most) {
    table.fail("place", fmt::format("found {}; it must be in 1 .. {}", column.place, most));
  }
  if (!(column.y_top > column.y_bottom)) table.fail("y_top", "it must be above the bottom joint");
  return column;
}

/// The tables of a fence's elements: the ground, the rocks and the column, in this order.
std::vector<SceneTable> element_tables(SceneTable& table) {
  std::vector<SceneTable> tables{table.table("ground")};
  for (const SceneTable& rock : table.numbered_tables("rock"))
    tables.push_back(rock);
  if (tables.size() == 1) table.fail("rock", "it is missing; a fence has at least one rock, headed [[fence.rock]]");
  tables.push_back(table.table("column"));
  return tables;
}

std::vector<int> wholes_or_none(SceneTable& table, std::string_view key) {
  return table.has(key) ? table.wholes(key) : std::vector<int>{};
}

}  // namespace

Fence read_fence(SceneTable& file, SceneSource& source) {
  file.allow({"title", "units", "fence"});
  source.units = unit_system(file.choice("units", {std::string{si.name}, std::string{us.name}}));
  Fence fence;
  fence.units = source.units;
  if (file.has("title")) fence.title = file.text("title");
  if (const std::string why = objection_to_title(fence.title); !why.empty()) file.fail("title", why);
  SceneTable table = file.table("fence");
  std::vector<std::string> known = keys<Fence>();
  known.insert(known.end(), {"history_elements", "history_codes", "ground", "ground_profile", "rock", "column",
                             "changed_column", "stretched_cable", "options"});
  table.allow(known);
  table.read_fields(fence);
  for (const auto& field : Fence::counts())
    table.read_count(fence, field);
  fence.history_elements = wholes_or_none(table, "history_elements");
  fence.history_codes = wholes_or_none(table, "history_codes");
  std::vector<SceneTable> elements = element_tables(table);
  fence.ground = read_element(elements.front(), ElementType::rock);
  if (table.has("ground_profile")) {
    for (const auto& [x, y] : table.pairs("ground_profile", dimension::length, dimension::length))
      fence.ground_profile.push_back({x, y});
  }
  for (std::size_t i = 1; i + 1 < elements.size(); ++i)
    fence.rocks.push_back(read_element(elements[i], ElementType::rock));
  fence.column = read_element(elements.back(), ElementType::column);
  for (SceneTable& changed : table.numbered_tables("changed_column")) {
    const scenes::ChangedColumn column = read_changed(changed, fence);
    if (std::ranges::find(fence.changed_columns, column.place, &scenes::ChangedColumn::place) !=
        fence.changed_columns.end()) {
      changed.fail("place", fmt::format("found {} again; each place can be changed once", column.place));
    }
    fence.changed_columns.push_back(column);
  }
  for (SceneTable& stretched : table.numbered_tables("stretched_cable")) {
    scenes::StretchedCable cable{.cable = stretched.text("cable")};
    stretched.read_fields(cable);
    stretched.allow({"stretch"});
    fence.stretched_cables.push_back(cable);
  }
  if (table.has("options")) fence.options = read_options(table.table("options"));
  if (const auto found = fault(fence)) {
    (found->element == 0 ? table : elements[found->element - 1]).fail(found->field, found->words);
  }
  return fence;
}

}  // namespace talus
