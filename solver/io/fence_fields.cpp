#include "solver/io/fence_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/base/units.hpp"
#include "solver/io/catalogue_entry.hpp"
#include "solver/io/fence1993/fence_names.hpp"
#include "solver/io/fence1993/fence_rules.hpp"
#include "solver/scenes/fence_scene.hpp"

namespace talus {
namespace {

using namespace catalogue;

Group fence_file() {
  return {.id = "fence file",
          .head = "file of a fence",
          .about = "a rockfall fence by the records of the 1993 deck; names before a colon below are those of the deck",
          .fields = {text("title", "title of the fence, printed with its results"), units_field(),
                     required(table("fence", "the fence"))}};
}

Group fence() {
  using scenes::Fence;
  Group group{.id = "fence", .head = "[fence]", .about = "numbers of the whole fence"};
  group.fields = {{.name = "rules",
                   .meaning = "takes the choices of the 1993 program for all options that are not given",
                   .form = Form::name,
                   .names = {std::string{fence_rules_1993}},
                   .absent = "the choices of Talus"},
                  quantity("duration", "time that the run lasts", dimension::time, Range::positive, "")};
  add_counts<Fence>(group);
  add_fields<Fence>(group);
  set_either(group, "duration", "steps");
  set_absent(group, "print_every", "a hundredth of all steps");
  set_absent(group, "history_every", "a thousandth of all steps");
  set_absent(group, "gravity_sign", "-1");
  set_absent(group, "connections", "2");
  set_absent(group, "layers", "1");
  set_absent(group, "gravity", fmt::format("{} m/s^2", exact::standard_gravity));
  require_with(group, "layer_spacing", "layers", "2");
  group.fields.insert(
      group.fields.end(),
      {{.name = "history_elements",
        .meaning = "elno: numbers of the elements whose histories are kept",
        .form = Form::wholes,
        .absent = "none"},
       {.name = "history_codes",
        .meaning = fmt::format("variab: codes of the quantities kept, at most {}", maximum_history_codes),
        .form = Form::wholes,
        .range = fmt::format("1 .. {}", last_history_code),
        .absent = "none"},
       required(table("ground", "element 1: a block whose upper side is the surface of the ground")),
       required(table("rock", "elements 2, 3, ..: the rocks, at least one", Form::tables)),
       required(table("column", "the last element: the pattern of all columns")),
       pairs("ground_profile", "points of an uneven surface in place of the level one, in the world", dimension::length,
             dimension::length),
       table("changed_column", "columns that differ from the others", Form::tables),
       table("stretched_cable", "cables that an earlier impact has stretched plastically", Form::tables),
       table("options", "choices that no record of the deck makes")});
  return group;
}

/// Ground, rocks and columns have the same fields, with different defaults.
void add_fence_elements(std::vector<Group>& groups) {
  using scenes::FenceElement;
  Group common{.id = "fence element",
               .head = "[fence.ground], [[fence.rock]], [fence.column]",
               .about = "fields of all elements"};
  std::vector<CatalogueField> own;
  add_fields<FenceElement>(common);
  add_counts<FenceElement>(common);
  for (const char* const name : {"density", "points"}) {
    own.push_back(field_of(common, name));
    std::erase_if(common.fields, [&](const CatalogueField& field) { return field.name == name; });
  }
  for (const auto& field : FenceElement::vectors())
    common.fields.push_back(vector(std::string{field.name}, std::string{field.meaning}, field.dimension, "0, 0"));
  const auto outlines = names_of<scenes::ElementOutline>();
  const std::string superquadric{name_of(scenes::ElementOutline::superquadric)};
  common.fields.push_back({.name = "shape",
                           .meaning = "outline with the half-lengths a and b, in place of power",
                           .form = Form::name,
                           .names = {outlines.begin() + 1, outlines.end()},
                           .absent = "by power"});
  common.fields.push_back(
      {.name = "exponent", .meaning = "n of |x/a|^n + |y/b|^n = 1, in place of power", .range = "> 1, at most 10000"});
  require_with(common, "exponent", "shape", superquadric);
  common.fields.push_back(quantity("along", "of a rock in the full model: position along the fence, 0 at mid-span",
                                   dimension::length, Range::any, "0"));
  groups.push_back(common);

  const auto add = [&](std::string id, std::string head, std::string about, scenes::ElementSolid solid,
                       std::string points, std::string held) {
    Group group{.id = std::move(id), .head = std::move(head), .about = std::move(about), .base = common.id};
    group.fields = own;
    set_absent(group, "points", std::move(points));
    group.fields.push_back(
        quantity("mass", "mass, from which the density follows", dimension::mass, Range::positive, ""));
    group.fields.push_back(choice("solid", "solid that gives mass and inertia", solid));
    group.fields.push_back({.name = "held",
                            .meaning = "motions that are held",
                            .form = Form::names,
                            .names = {held_axes.begin(), held_axes.end()},
                            .absent = std::move(held)});
    set_either(group, "density", "mass");
    groups.push_back(std::move(group));
  };
  add("fence ground", "[fence.ground]", "element 1, a block whose upper side is the surface",
      scenes::ElementSolid::block, "2", "all");
  for (const char* const name : {"density", "mass"}) {
    set_absent(groups.back(), name, "none: the ground is held");
    field_of(groups.back(), name).alternative.clear();
  }
  add("fence rock", "[[fence.rock]]", "one table for each rock; one rock must move", scenes::ElementSolid::ellipsoid,
      "4", "none");
  add("fence column", "[fence.column]", "the pattern of all columns", scenes::ElementSolid::cylinder, "2", "none");
}

Group changed_column() {
  Group group{.id = "fence changed_column",
              .head = "[[fence.changed_column]]",
              .about = "a column of different size, in every layer and on both sides"};
  add_counts<scenes::ChangedColumn>(group);
  add_fields<scenes::ChangedColumn>(group);
  for (const auto& field : scenes::ChangedColumn::fields())
    set_absent(group, field.name, "as the other columns");
  return group;
}

Group stretched_cable() {
  Group group{.id = "fence stretched_cable",
              .head = "[[fence.stretched_cable]]",
              .about = "a cable that an earlier impact has stretched (talus convert --after)"};
  group.fields = {required(text("cable", "its name: top1, bottom-2, back_top3, .."))};
  add_fields<scenes::StretchedCable>(group);
  return group;
}

std::string option_meaning(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> meanings[] = {
      {"symmetry", "one side of a symmetric fence and impact, or all columns"},
      {"even_centre", "central columns of an even count in the half model: one doubled body, or two"},
      {"contact", "forces at boundary nodes (1993), one resultant, or nodes with the smoother body's normal"},
      {"calibration", "mass that a dashpot follows from: two particles (Eq. 21 of 1993), or the effective mass"},
      {"end_rule", "end of a contact: clamped (never pulls) or attractive (1993)"},
      {"start", "contact forces act half a step before the start, as in 1993, or not"},
      {"bottom_end", "bottom cable ends at the last column, or at anchors below those of the top cable"},
      {"column_ground", "columns pass through the ground (1993), or touch it as rocks do"},
      {"end", "end of the run before its last step: never, all rocks past exit_x, or all rocks at rest"},
      {"sleep", "columns that nothing has moved are left out: never, with the same bits, or to 1e-13"}};
  const auto found = std::ranges::find(meanings, name, &std::pair<std::string_view, std::string_view>::first);
  TALUS_DEMAND(found != std::end(meanings));
  return std::string{found->second};
}

/// Default of an option as text: that of Talus and, if it differs, that of the 1993 rules.
std::string usual_option(std::string_view current, std::string_view historical) {
  if (current == historical) return std::string{current};
  return fmt::format("{} (with rules = \"{}\": {})", current, fence_rules_1993, historical);
}

Group options() {
  using scenes::FenceOptions;
  Group group{.id = "fence options",
              .head = "[fence.options]",
              .about = "choices that no record of the 1993 deck makes; this table may be left out"};
  const FenceOptions current = scenes::current_options(), historical;
  std::vector<std::string> of_1993;
  for_each_choice(historical, [&](std::string_view, auto option) { of_1993.emplace_back(name_of(option)); });
  for_each_choice(current, [&](std::string_view name, auto option) {
    CatalogueField field = choice(std::string{name}, option_meaning(name), option);
    field.absent = usual_option(field.absent, of_1993[group.fields.size()]);
    group.fields.push_back(std::move(field));
  });
  group.fields.push_back(
      integrator_field(integrator_choices(), usual_option(current.integrator, historical.integrator)));
  add_fields<FenceOptions>(group, current);
  set_absent(group, "tolerance", usual_option(text_of(current.tolerance), text_of(historical.tolerance)));
  require_with(group, "exit_x", "end", std::string{name_of(scenes::FenceEnd::exit)});
  field_of(group, "exit_x").absent.clear();
  group.fields.push_back(pairs("table",
                               "yield force of both cables as a multiple of limit_top and limit_bottom, over the "
                               "plastic strain, beyond (0, 1); in place of hardening",
                               dimension::number, dimension::number));
  group.fields.push_back(
      table("watch", "what the run monitor does when it finds a limit exceeded", Form::table_or_off));
  return group;
}

}  // namespace

std::vector<FieldGroup> fence_field_groups() {
  std::vector<Group> groups{fence_file(), fence()};
  add_fence_elements(groups);
  groups.insert(groups.end(),
                {changed_column(), stretched_cable(), options(),
                 watch_group("fence watch", "watch of [fence.options]", scenes::current_options().watch)});
  return groups;
}

}  // namespace talus
