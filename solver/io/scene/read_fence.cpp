#include "solver/io/scene/read_fence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/base/unit_table.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/fence1993/fence_names.hpp"
#include "solver/io/fence1993/fence_rules.hpp"
#include "solver/io/scene/scene_parts.hpp"
#include "solver/scenes/fence_element.hpp"
#include "solver/stability/step_advice.hpp"

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

/// Default points of a quadrant: a rock has twelve nodes, a column four (1993).
constexpr int usual_rock_points = 4, usual_column_points = 2;

/// Role of an element in the fence.
enum class ElementPart { ground, rock, column };

/// Reads the outline: by `power` as in a deck, or by `shape`, with `exponent` for a superquadric.
void read_outline(SceneTable& table, FenceElement& element) {
  const auto names = Names<scenes::ElementOutline>::list;
  if (table.has("shape")) {
    table.refuse("power", "found beside shape; give one of the two");
    // A wrong shape with an exponent is most likely a misspelt superquadric.
    if (table.has("exponent")) element.outline = scenes::ElementOutline::superquadric;
    table.guard([&] {
      const std::string shape = table.choice("shape", {names.begin() + 1, names.end()});
      element.outline = value_named<scenes::ElementOutline>("shape", shape);
    });
  } else if (table.has("exponent")) {
    table.refuse("power", "found beside exponent (n = 2/power); give one of the two");
    element.outline = scenes::ElementOutline::superquadric;
  }
  if (element.outline != scenes::ElementOutline::superquadric)
    return table.refuse("exponent", "only a superquadric has one; leave it out or give shape = \"superquadric\"");
  element.exponent = table.number("exponent", Range::positive);
  if (!(element.exponent > 1.0) || element.exponent > 1e4)
    table.report("exponent", fmt::format("found {}; it must be > 1 and at most 10000", element.exponent));
}

/// Makes the outline of a block or cylinder of power 0 a rectangle, for contacts by resultants: n = 2/power is
/// infinite, and a cylinder seen from the side is a rectangle. In the nodal contacts of 1993, power 0 means n = 20.
void take_rectangle(FenceElement& element) {
  const bool by_power = element.outline == scenes::ElementOutline::by_power && element.power == 0.0;
  if (by_power && element.solid != scenes::ElementSolid::ellipsoid) element.outline = scenes::ElementOutline::rectangle;
}

/// Reads the density, or computes it from the mass of the solid.
void read_density(SceneTable& table, FenceElement& element, ElementPart part) {
  if (table.has("mass")) {
    table.refuse("density", "found beside mass; give one of the two");
    const double mass = table.quantity("mass", dimension::mass, Range::positive);
    element.density = 1.0;
    element.density = mass / mass_properties(element).mass;
  } else if (table.has("density") || part != ElementPart::ground) {
    if (!table.has("density")) return table.report("density", "it is missing; give density or mass");
    element.density = table.quantity("density", dimension::density, Range::positive);
  } else {
    element.density = 1.0;  // the ground is held, so its mass has no effect
  }
}

FenceElement read_element(SceneTable table, ElementPart part) {
  std::vector<std::string> known = keys<FenceElement>();
  for (const auto& field : FenceElement::vectors())
    known.emplace_back(field.name);
  known.insert(known.end(), {"solid", "shape", "exponent", "mass", "held", "along"});
  table.allow(known);
  FenceElement element;
  element.type = part == ElementPart::column ? ElementType::column : ElementType::rock;
  element.solid = part == ElementPart::ground ? scenes::ElementSolid::block
                  : part == ElementPart::rock ? scenes::ElementSolid::ellipsoid
                                              : scenes::ElementSolid::cylinder;
  element.solid = table.choice_or("solid", element.solid);
  for (const auto& field : FenceElement::fields()) {
    if (field.name != "density") table.read_field(element, field);
  }
  read_outline(table, element);
  read_density(table, element, part);
  element.along = table.quantity_or("along", dimension::length, 0.0);
  element.points = part == ElementPart::rock ? usual_rock_points : usual_column_points;
  for (const auto& field : FenceElement::counts()) {
    if (table.has(field.name)) table.read_count(element, field);
  }
  for (const auto& field : FenceElement::vectors())
    element.*field.member = table.vector_or(field.name, field.dimension, {});
  if (table.has("held")) {
    table.guard([&] {
      for (const std::string& axis : table.choices("held", {held_axes.begin(), held_axes.end()}))
        element.held[static_cast<std::size_t>(std::ranges::find(held_axes, axis) - held_axes.begin())] = true;
    });
  } else if (part == ElementPart::ground) {
    element.held = {true, true, true};
  }
  return element;
}

scenes::FenceOptions read_options(SceneTable table, scenes::FenceOptions options) {
  std::vector<std::string> known = field_names<scenes::FenceOptions>();
  for_each_choice(options, [&](std::string_view name, auto&) { known.emplace_back(name); });
  known.insert(known.end(), {"watch", "integrator", "table"});
  table.allow(known);
  for_each_choice(options, [&](std::string_view name, auto& choice) { choice = table.choice_or(name, choice); });
  if (table.has("watch")) table.guard([&] { options.watch = read_watch(table, "watch", options.watch); });
  if (table.has("integrator")) {
    table.guard([&] { options.integrator = table.choice("integrator", integrator_choices()); });
    // The default tolerance does not apply to a method without step control.
    if (!table.has("tolerance") && options.integrator != automatic_integrator && !has_step_control(options.integrator))
      options.tolerance = 0.0;
  }
  table.read_fields(options);
  if (options.end == scenes::FenceEnd::exit && !table.has("exit_x"))
    table.report("exit_x", "it is missing; a run that ends by exit needs the x that the rocks pass");
  if (table.has("table")) {
    table.guard([&] {
      for (const auto& [strain, multiple] : table.pairs("table", dimension::number, dimension::number))
        options.table.push_back({strain, multiple});
    });
  }
  return options;
}

const CountField<Fence>& count_field(std::string_view name) {
  static constexpr auto counts = Fence::counts();
  const auto found = std::ranges::find(counts, name, &CountField<Fence>::name);
  TALUS_DEMAND(found != counts.end());
  return *found;
}

/// Reads the length of a fence's run: `steps`, or the `duration`, which is returned and from which the steps follow
/// later [T]; and how often a state and a row are written to its files.
std::optional<double> read_steps(SceneTable& table, Fence& fence) {
  std::optional<double> duration;
  fence.steps = fence.print_every = fence.history_every = 1;
  if (table.has("duration")) {
    table.refuse("steps", "found beside duration; give one of the two");
    duration = table.quantity("duration", dimension::time, Range::positive);
  } else if (table.has("steps")) {
    table.read_count(fence, count_field("steps"));
  } else {
    table.report("duration", "it is missing; give the time that the run lasts, e.g. \"0.5 s\" (or steps)");
  }
  for (const std::string_view name : {"print_every", "history_every"}) {
    if (table.has(name)) table.read_count(fence, count_field(name));
  }
  return duration;
}

/// Sets the number of steps that the duration takes, for a fence that can be built.
void set_steps(SceneTable& table, Fence& fence, std::optional<double> duration) {
  if (!table.has("rules") && !table.has("step_factor")) {
    // The step of the 1993 rule is derived from a cable, not from the contacts.
    const scenes::FenceScene made = fence_scene(table, fence);
    if (!chooses_steps(made.scene.integrator))
      fence.step_factor = table.placed([&] { return automatic_step(made.scene); }) / made.critical_step;
  }
  if (duration) {
    const double step = fence_scene(table, fence).scene.plan.step;
    const double steps = std::ceil(*duration / step - 1e-9);
    if (!(steps <= 1e9))
      table.fail("duration", fmt::format("it takes {:.3g} steps of {:.3g}; there can be 1e9", steps, step));
    fence.steps = static_cast<long>(steps);
  }
  constexpr long usual_states = 100, usual_rows = 1000;
  if (!table.has("print_every")) fence.print_every = std::max(1L, fence.steps / usual_states);
  if (!table.has("history_every")) fence.history_every = std::max(1L, fence.steps / usual_rows);
}

/// Reads a changed column; values that its table does not give are those of the other columns.
scenes::ChangedColumn read_changed(SceneTable& table, const Fence& fence) {
  table.allow(keys<scenes::ChangedColumn>());
  const FenceElement& pattern = fence.column;
  scenes::ChangedColumn column{1, pattern.a, pattern.b, pattern.density, fence.y_top, fence.y_bottom};
  table.read_fields(column);
  for (const auto& field : scenes::ChangedColumn::counts())
    table.read_count(column, field);
  return column;
}

/// Reports errors in the changed columns of a fence that was read from these tables.
void check_changed(const std::vector<SceneTable>& tables, const Fence& fence) {
  const std::vector<scenes::ChangedColumn>& columns = fence.changed_columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const int number = columns[i].number;
    if (const int maximum = columns_of_half(fence); number > maximum) {
      tables[i].report("number", fmt::format("found {}; it must be in 1 .. {}", number, maximum));
    }
    if (!(columns[i].y_top > columns[i].y_bottom)) tables[i].report("y_top", "it must be above the bottom joint");
    const auto before = columns.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::ranges::find(columns.begin(), before, number, &scenes::ChangedColumn::number) != before)
      tables[i].report("number", fmt::format("found {} again; each column can be changed once", number));
  }
}

std::vector<int> wholes_or_none(SceneTable& table, std::string_view key) {
  std::vector<int> found;
  if (table.has(key)) table.guard([&] { found = table.wholes(key); });
  return found;
}

}  // namespace

scenes::FenceScene fence_scene(SceneTable& table, const Fence& fence) {
  std::optional<FenceFault> fault;
  auto made = table.placed([&]() -> std::optional<scenes::FenceScene> {
    try {
      return scenes::fence_scene(fence);
    } catch (const scenes::FenceError& error) {
      fault = error.fault();
      return {};
    }
  });
  if (made) return std::move(*made);
  const std::size_t element = fault->element, rocks = fence.rocks.size();
  const SceneTable at = element == 0           ? table
                        : element == 1         ? table.table("ground")
                        : element <= rocks + 1 ? table.numbered_tables("rock")[element - 2]
                                               : table.table("column");
  at.fail(fault->field, fault->message);
}

Fence read_fence(SceneTable& file, SceneSource& source) {
  file.allow({"title", "units", "fence"});
  source.guard(file.line(), [&] { source.units = unit_system(file.choice("units", unit_system_names())); });
  Fence fence;
  fence.units = source.units;
  source.guard(file.line(), [&] {
    fence.title = file.title();
    if (const std::string why = title_error(fence.title); !why.empty()) file.fail("title", why);
  });
  SceneTable table = file.table("fence");
  std::vector<std::string> known = keys<Fence>();
  known.insert(known.end(), {"rules", "duration", "history_elements", "history_codes", "ground", "ground_profile",
                             "rock", "column", "changed_column", "stretched_cable", "options"});
  table.allow(known);
  bool historical = false;
  if (table.has("rules"))
    table.guard([&] { historical = table.choice("rules", {std::string{fence_rules_1993}}) == fence_rules_1993; });
  fence.options = historical ? scenes::FenceOptions{} : scenes::current_options();
  fence.gravity = exact::standard_gravity / si_size(source.units, dimension::acceleration);
  fence.gravity_sign = -1, fence.connections = 2, fence.layers = 1;
  for (const auto& field : Fence::fields())
    if (field.name != "gravity" || table.has(field.name)) table.read_field(fence, field);
  for (const auto& field : Fence::counts()) {
    const bool required = field.name == "columns";
    const bool of_run = field.name == "steps" || field.name == "print_every" || field.name == "history_every";
    if (!of_run && (required || table.has(field.name))) table.read_count(fence, field);
  }
  fence.history_elements = wholes_or_none(table, "history_elements");
  fence.history_codes = wholes_or_none(table, "history_codes");
  std::vector<SceneTable> elements;
  const auto read = [&](const SceneTable& element, ElementPart part) {
    elements.push_back(element);
    FenceElement found;
    source.guard(element.line(), [&] { found = read_element(element, part); });
    return found;
  };
  source.guard(table.line(), [&] { fence.ground = read(table.table("ground"), ElementPart::ground); });
  for (const SceneTable& rock : table.numbered_tables("rock"))
    fence.rocks.push_back(read(rock, ElementPart::rock));
  if (!table.has("rock") || (fence.rocks.empty() && !source.has_nameless("rock")))
    table.report("rock", "it is missing; a fence has at least one rock, headed [[fence.rock]]");
  source.guard(table.line(), [&] { fence.column = read(table.table("column"), ElementPart::column); });
  if (table.has("ground_profile")) {
    table.guard([&] {
      for (const auto& [x, y] : table.pairs("ground_profile", dimension::length, dimension::length))
        fence.ground_profile.push_back({x, y});
    });
  }
  if (table.has("options"))
    source.guard(table.line(), [&] { fence.options = read_options(table.table("options"), fence.options); });
  if (fence.options.contact == scenes::FenceContact::resultant) {
    take_rectangle(fence.column);
    for (FenceElement& rock : fence.rocks)
      take_rectangle(rock);
  }
  std::vector<SceneTable> changed = table.numbered_tables("changed_column");
  for (SceneTable& column : changed)
    fence.changed_columns.push_back(read_changed(column, fence));
  for (SceneTable& stretched : table.numbered_tables("stretched_cable")) {
    stretched.guard([&] {
      scenes::StretchedCable cable{.cable = stretched.text("cable")};
      stretched.allow({"stretch"});
      stretched.read_fields(cable);
      fence.stretched_cables.push_back(cable);
    });
  }
  const std::optional<double> duration = read_steps(table, fence);
  // The following checks combine all numbers, so these must be valid.
  source.check();
  source.collect();
  check_changed(changed, fence);
  for (const FenceFault& fault : faults(fence))
    (fault.element == 0 ? table : elements[fault.element - 1]).report(fault.field, fault.message);
  source.check();
  set_steps(table, fence, duration);
  return fence;
}

}  // namespace talus
