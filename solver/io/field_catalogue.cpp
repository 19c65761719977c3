#include "solver/io/field_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/cell/cell_plan.hpp"
#include "solver/granular/disc_method.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/fence1993/fence_names.hpp"
#include "solver/io/fence1993/fence_rules.hpp"
#include "solver/io/scene/scene_parts.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus {
namespace {

using Form = FieldForm;
using Group = FieldGroup;

template <class Enum>
std::vector<std::string> names_of() {
  return {Names<Enum>::list.begin(), Names<Enum>::list.end()};
}

std::string text_of(double value) {
  return value == std::numeric_limits<double>::max() ? "no limit" : fmt::format("{}", value);
}

/// Field whose value is one of the names of an enum; `absent` is the default.
template <class Enum>
CatalogueField choice(std::string name, std::string meaning, Enum absent) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .form = Form::name,
          .names = names_of<Enum>(),
          .absent = std::string{name_of(absent)}};
}

CatalogueField on_or_off(std::string name, std::string meaning, std::string absent) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .form = Form::name,
          .names = {"on", "off"},
          .absent = std::move(absent)};
}

CatalogueField table(std::string name, std::string meaning, Form form = Form::table) {
  return {.name = std::move(name), .meaning = std::move(meaning), .form = form};
}

CatalogueField text(std::string name, std::string meaning) {
  return {.name = std::move(name), .meaning = std::move(meaning), .form = Form::text};
}

CatalogueField required(CatalogueField field, std::string condition = {}) {
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
          .range = range == Range::any ? "" : std::string{words(range)},
          .absent = std::move(absent)};
}

CatalogueField pairs(std::string name, std::string meaning, Dimension first, Dimension second) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .form = Form::pairs,
          .dimension = first,
          .second = second};
}

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
                            .range = fmt::format("{} .. {}", field.least, field.most),
                            .required = true});
  }
}

/// The field of this name, which must already be in the group.
CatalogueField& field_of(Group& group, std::string_view name) {
  const auto found = std::ranges::find(group.fields, name, &CatalogueField::name);
  TALUS_DEMAND(found != group.fields.end());
  return *found;
}

/// Makes a field optional with the default `absent`.
void set_absent(Group& group, std::string_view name, std::string absent) {
  CatalogueField& field = field_of(group, name);
  field.required = false;
  field.absent = std::move(absent);
}

void set_required(Group& group, std::string_view name, std::string condition) {
  CatalogueField& field = field_of(group, name);
  field = required(std::move(field), std::move(condition));
}

/// Makes two fields alternatives of which one is required.
void set_either(Group& group, std::string_view name, std::string_view other) {
  for (const auto& [one, alternative] : {std::pair{name, other}, std::pair{other, name}}) {
    set_required(group, one, "");
    field_of(group, one).alternative = alternative;
  }
}

void set_with(Group& group, std::string_view name, std::string with, std::string value = {}) {
  CatalogueField& field = field_of(group, name);
  field.with = std::move(with);
  field.with_value = std::move(value);
}

/// Makes a field required if the field `with` is given; otherwise it may be omitted.
void require_with(Group& group, std::string_view name, std::string with, std::string value = {}) {
  field_of(group, name).required = true;
  set_with(group, name, std::move(with), std::move(value));
}

CatalogueField units_field() {
  return required({.name = "units",
                   .meaning = "unit system of the results; quantities in the file may have any units",
                   .form = Form::name,
                   .names = {std::string{si.name}, std::string{us.name}}});
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

Group scene_file() {
  return {.id = "scene",
          .head = "file of a scene",
          .about = "bodies in the plane; x is horizontal, y up, angles counter-clockwise",
          .fields = {text("title", "title of the scene, printed with its results"), units_field(),
                     vector("gravity", "acceleration of free fall", dimension::acceleration, "none"),
                     required(table("body", "the bodies, at least one: [[body]]", Form::tables)),
                     table("contact", "pairs of bodies that can touch: [[contact]]", Form::tables),
                     table("cable", "cables between bodies or points of the world: [[cable]]", Form::tables),
                     table("hanger", "joints that break, where cables end at a body: [[hanger]]", Form::tables),
                     required(table("run", "method, step and end of the run: [run]")),
                     table("fence", "a rockfall fence, in place of gravity, bodies and run: see file of a fence")}};
}

Group body() {
  Group group{.id = "body", .head = "[[body]]", .about = "a rigid body, a particle or a fixed obstacle"};
  group.fields = {required(text("name", "unique name; heads the columns of the body in histories")),
                  required({.name = "mobility",
                            .meaning = "coordinates that can change: free (x, y, angle), particle (x, y), pinned "
                                       "(angle), sliding (x or y), guided (x or y, and the angle)",
                            .form = Form::name,
                            .names = names_of<Mobility>()}),
                  table("shape", "outline, by which it touches others; without one it touches nothing")};
  add_fields<Body>(group);
  set_required(group, "mass", "if it is not fixed");
  set_required(group, "inertia", "if it can turn");
  field_of(group, "moment").condition = "if it can turn";
  group.fields.push_back(
      required(vector("position", "centre of mass at the start, in the world", dimension::length, "")));
  group.fields.push_back(
      required(vector("pin", "pin, in the axes of the body", dimension::length, ""), "if it is pinned or guided"));
  CatalogueField velocity = vector("velocity", "of the centre of mass at the start", dimension::velocity, "at rest");
  velocity.condition = "if it is not fixed or pinned";
  CatalogueField spin = quantity("spin", "angular velocity at the start, counter-clockwise positive",
                                 dimension::angular_velocity, Range::any, "0");
  spin.condition = "if it can turn";
  CatalogueField force =
      vector("force", "constant force at the centre of mass, in the world", dimension::force, "none");
  force.condition = "if it is not fixed";
  group.fields.insert(group.fields.end(), {velocity, spin, force});
  return group;
}

void add_shapes(std::vector<Group>& groups) {
  groups.push_back({.id = "shape",
                    .head = "shape of a body",
                    .about = "written as shape = { kind = \"circle\", .. } or as a table [body.shape]",
                    .fields = {required(
                        {.name = "kind", .meaning = "kind of outline", .form = Form::name, .names = shape_names()})}});
  const auto add = [&]<class T>(const T& shape) {
    Group group{
        .id = fmt::format("shape {}", T::name), .head = fmt::format("shape, kind = \"{}\"", T::name), .base = "shape"};
    add_fields(group, shape);
    if constexpr (requires { shape.points; }) {
      group.fields.push_back(required(pairs("points", "two or more of its surface, x growing, in the axes of the body",
                                            dimension::length, dimension::length)));
    }
    groups.push_back(std::move(group));
  };
  for (const std::string& name : shape_names())
    visit_named<Shape>(name, add);
}

Group contact() {
  Group group{.id = "contact", .head = "[[contact]]", .about = "two bodies that can touch, and the law by which"};
  group.fields = {
      required(text("name", "unique name; heads the columns of the contact in histories")),
      required({.name = "between", .meaning = "names of the two bodies", .form = Form::two_texts}),
      required(
          {.name = "law", .meaning = "law of the normal force", .form = Form::name, .names = ContactLaws::names()}),
      choice("method", "one resultant force from the exact overlap, or forces at boundary nodes as in 1993",
             ContactMethod::resultant),
      {.name = "nodes",
       .meaning = "boundary nodes of both bodies, or of each",
       .form = Form::one_or_two,
       .range = "> 0",
       .absent = fmt::format("{}", Contact{}.nodes[0])},
      choice("node_depth", "rule for the overlap and normal of a node in a superquadric", NodeDepth::nearest),
      quantity("friction", "coefficient of Coulomb friction", dimension::number, Range::non_negative,
               "the contact is smooth"),
      quantity("shear_stiffness", "tangential stiffness k_s of friction that sticks", dimension::stiffness,
               Range::positive, "the normal stiffness"),
      quantity("shear_damping", "tangential dashpot of friction that sticks", dimension::damping, Range::non_negative,
               "k_s c/k_n of a linear spring and dashpot, else 0")};
  for (const char* const name : {"nodes", "node_depth"})
    set_with(group, name, "method", "nodes");
  for (const char* const name : {"shear_stiffness", "shear_damping"})
    set_with(group, name, "friction");
  return group;
}

CatalogueField end_rule_field() {
  return choice("end_rule", "end of a contact: clamped (never pulls) or attractive (1993)", EndRule::clamped);
}
CatalogueField restitution_field() {
  return quantity("restitution", "coefficient of restitution of an impact", dimension::number, Range::positive_fraction,
                  "");
}

void add_contact_laws(std::vector<Group>& groups) {
  ContactLaws::for_each([&]<class L>(const L& law) {
    Group group{.id = fmt::format("contact {}", L::name),
                .head = fmt::format("[[contact]], law = \"{}\"", L::name),
                .base = "contact"};
    add_fields(group, law);
    if constexpr (HasEndRule<L>) group.fields.push_back(end_rule_field());
    if constexpr (HasHertzDashpot<L>) {
      group.fields.push_back(choice("dashpot",
                                    "tsuji: in proportion to overlap^(1/4), the same restitution at every speed; or "
                                    "constant",
                                    law.dashpot));
    }
    if constexpr (SetsEveryRestitution<L>) {
      group.fields.push_back(restitution_field());
      if (L::restitution_field.is_required) set_either(group, L::restitution_field.name, "restitution");
      if constexpr (HasEndRule<L>) {
        group.fields.push_back(choice("restitution_rule",
                                      "mass that the dashpot follows from: the effective mass at each impact, or the "
                                      "two particle masses (Eq. 21 of 1993)",
                                      RestitutionRule::effective_mass));
        set_with(group, "restitution_rule", "restitution");
      }
      if constexpr (VariesRestitution<L>) {
        group.fields.push_back(quantity("restitution_speed",
                                        HasHertzDashpot<L> ? "speed of approach at which the restitution holds; needed "
                                                             "with the dashpot constant"
                                                           : "speed of approach at which the restitution holds",
                                        dimension::velocity, Range::positive, ""));
        set_with(group, "restitution_speed", "restitution");
        if constexpr (!HasHertzDashpot<L>) require_with(group, "restitution_speed", "restitution");
      }
    }
    groups.push_back(std::move(group));
  });
}

void add_cables(std::vector<Group>& groups) {
  groups.push_back(
      {.id = "cable",
       .head = "[[cable]]",
       .about = "pulls while it is longer than its slack length",
       .fields = {
           required(text("name", "unique name; heads the columns of the cable in histories")),
           required({.name = "law", .meaning = "law of the tension", .form = Form::name, .names = CableLaws::names()}),
           required(table("from", "one end")), required(table("to", "the other end")),
           quantity("rest_length", "length at which it is just slack", dimension::length, Range::non_negative,
                    "the distance of its ends at the start"),
           quantity("slack", "added to the rest length", dimension::length, Range::any, "0")}});
  groups.push_back({.id = "cable end",
                    .head = "from and to of a cable",
                    .about = "written as from = { body = \"rock\", point = [..] }",
                    .fields = {text("body", "name of the body, in whose axes the point is"),
                               required({.name = "point",
                                         .meaning = "where the cable ends; the third component is along the fence",
                                         .form = Form::point,
                                         .dimension = dimension::length})}});
  field_of(groups.back(), "body").absent = "the point is of the world";
  CableLaws::for_each([&]<class L>(const L& law) {
    Group group{.id = fmt::format("cable {}", L::name),
                .head = fmt::format("[[cable]], law = \"{}\"", L::name),
                .base = "cable"};
    add_fields(group, law);
    if constexpr (HasYieldTable<L>) {
      group.fields.push_back(pairs("table", "yield force over the plastic stretch, beyond (0, yield)",
                                   dimension::length, dimension::force));
      set_with(group, "table", "yield");
    }
    groups.push_back(std::move(group));
  });
}

Group hanger() {
  return {.id = "hanger",
          .head = "[[hanger]]",
          .about = "a joint where one or two cables end at a body; when it breaks, two cables continue as one",
          .fields = {required(text("name", "unique name")), required(text("body", "name of the body")),
                     required({.name = "point",
                               .meaning = "where the cables end, in the axes of the body",
                               .form = Form::point,
                               .dimension = dimension::length}),
                     required(quantity("strength", "sum of the cables' pulls at which the joint breaks",
                                       dimension::force, Range::positive, ""))}};
}

Group run() {
  Group group{.id = "run", .head = "[run]", .about = "method, step and end of the run"};
  group.fields = {
      integrator_field(integrator_choices(), std::string{automatic_integrator}),
      quantity("tolerance", "error that a method with step control accepts, relative to the run's own size",
               dimension::number, Range::positive, fmt::format("{:g} where one is needed", usual_tolerance)),
      required({.name = "step",
                .meaning = "length of a step, or \"auto\" for 1/20 of the linear limit, 1/200 of the shortest contact "
                           "at most; of a method that chooses its steps: time between outputs",
                .form = Form::time_or_auto,
                .dimension = dimension::time,
                .range = "> 0"},
               "for a method of fixed step"),
      required(quantity("end", "time at which the run ends", dimension::time, Range::positive, "")),
      quantity("interval", "time between rows of the history", dimension::time, Range::positive,
               "a thousandth of the end"),
      on_or_off("ledger", "energy and momentum balance of every step", "on"),
      table("watch", "what the run monitor does when it finds a limit exceeded", Form::table_or_off)};
  return group;
}

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
        .meaning = fmt::format("variab: codes of the quantities kept, at most {}", most_history_codes),
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
  for_each_choice(historical, [&](std::string_view, auto option) { of_1993.emplace_back(choice_name(option)); });
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

Group cell_file() {
  return {.id = "cell file",
          .head = "file of a shear cell",
          .about = "discs between a base and a driven block, run by `talus cell`",
          .fields = {text("title", "title of the cell, printed with its results"), units_field(),
                     required(table("cell", "discs, walls and their law")),
                     required(table("run", "method, step and end of the run"))}};
}

void add_cell(std::vector<Group>& groups) {
  Group group{.id = "cell", .head = "[cell]", .about = "names in capitals are those of CNTRL.DAT of 1989"};
  add_fields<ShearCell>(group);
  add_counts<ShearCell>(group);
  group.fields.push_back(quantity("overburden",
                                  "pressure of the block's weight, block_mass gravity/(wall_discs "
                                  "diameter^2)",
                                  dimension::pressure, Range::positive, ""));
  set_either(group, "block_mass", "overburden");
  require_with(group, "gravity", "overburden");
  group.fields.push_back({.name = "law",
                          .meaning = "law of the normal force",
                          .form = Form::name,
                          .names = DiscLaws::names(),
                          .absent = std::string{LatchingSpring::name}});
  group.fields.push_back(quantity("friction", "coefficient of Coulomb friction; with it discs turn", dimension::number,
                                  Range::non_negative, "discs are smooth and do not turn"));
  group.fields.push_back(quantity("shear_stiffness", "tangential stiffness of friction that sticks",
                                  dimension::stiffness, Range::positive, "the normal stiffness"));
  set_with(group, "shear_stiffness", "friction");
  group.fields.push_back({.name = "seed",
                          .meaning = "of the random velocities at the start",
                          .form = Form::whole,
                          .range = fmt::format("0 .. {}", most_seed),
                          .absent = "0"});
  groups.push_back(std::move(group));
  DiscLaws::for_each([&]<class L>(const L& law) {
    Group of_law{
        .id = fmt::format("cell {}", L::name), .head = fmt::format("[cell], law = \"{}\"", L::name), .base = "cell"};
    add_fields(of_law, law);
    of_law.fields.push_back(restitution_field());
    set_either(of_law, L::restitution_field.name, "restitution");
    if constexpr (HasEndRule<L>) of_law.fields.push_back(end_rule_field());
    groups.push_back(std::move(of_law));
  });
}

Group cell_run() {
  Group group{.id = "cell run", .head = "[run] of a shear cell", .about = "method, step and end of the run"};
  add_fields<CellPlan>(group);
  group.fields.push_back(integrator_field(disc_method_names(), CellPlan{}.integrator));
  group.fields.push_back(on_or_off("jump", "pass time in which nothing can touch at once", "off"));
  group.fields.push_back(
      choice("images", "discs across the borders: the nearest image, or virtual discs and all pairs as in 1989 (slow)",
             Images::nearest));
  group.fields.push_back(
      on_or_off("historical", "as the runs of 1989 may have been: euler, K1/K2 = 0.45, step 1e-7", "off"));
  group.fields.push_back(on_or_off("pictures", "PIC.DAT and the states for pictures at each output", "off"));
  return group;
}

std::vector<Group> all_groups() {
  std::vector<Group> groups{scene_file(), body()};
  add_shapes(groups);
  groups.push_back(contact());
  add_contact_laws(groups);
  add_cables(groups);
  groups.push_back(hanger());
  groups.push_back(run());
  groups.push_back(watch_group("watch", "watch of [run]", {}));
  groups.push_back(fence_file());
  groups.push_back(fence());
  add_fence_elements(groups);
  groups.insert(groups.end(),
                {changed_column(), stretched_cable(), options(),
                 watch_group("fence watch", "watch of [fence.options]", scenes::current_options().watch), cell_file()});
  add_cell(groups);
  groups.push_back(cell_run());
  return groups;
}

}  // namespace

const std::vector<FieldGroup>& field_catalogue() {
  static const std::vector<FieldGroup> groups = all_groups();
  return groups;
}

const FieldGroup& field_group(std::string_view id) {
  std::vector<std::string> ids;
  for (const FieldGroup& group : field_catalogue()) {
    if (group.id == id) return group;
    ids.push_back(group.id);
  }
  throw unknown_name("group of fields", id, ids);
}

std::vector<CatalogueField> all_fields(const FieldGroup& group) {
  std::vector<CatalogueField> fields;
  if (!group.base.empty()) fields = all_fields(field_group(group.base));
  fields.insert(fields.end(), group.fields.begin(), group.fields.end());
  return fields;
}

}  // namespace talus
