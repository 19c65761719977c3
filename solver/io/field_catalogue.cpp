#include "solver/io/field_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/cell/cell_plan.hpp"
#include "solver/granular/disc_method.hpp"
#include "solver/io/catalogue_entry.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/fence_fields.hpp"
#include "solver/io/scene/scene_parts.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus {
namespace {

using namespace catalogue;

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
      group.fields.push_back(required(pairs("points",
                                            "two or more of its surface, x growing, in the axes of the body; the "
                                            "ground is below, the first and the last segment do not end",
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
      quantity("shear_damping",
               "tangential dashpot of friction that sticks; of mindlin at an overlap equal to the radius",
               dimension::damping, Range::non_negative, "k_s c/k_n of two linear springs and dashpots, else 0")};
  for (const char* const name : {"nodes", "node_depth"})
    set_with(group, name, "method", "nodes");
  for (const char* const name : {"shear_stiffness", "shear_damping"})
    set_with(group, name, "friction");
  return group;
}

CatalogueField end_rule_field() {
  return choice("end_rule", "end of a contact: clamped (never pulls) or attractive (1993)", EndRule::clamped);
}
CatalogueField dashpot_field(HertzDashpot absent) {
  return choice("dashpot", "tsuji: in proportion to overlap^(1/4), the same restitution at every speed; or constant",
                absent);
}
CatalogueField restitution_field() {
  return quantity("restitution", "coefficient of restitution of an impact", dimension::number, Range::positive_fraction,
                  "");
}

/// Adds the choice between the friction laws that contacts of law L can have, and their fields that the group `contact`
/// does not have.
template <class Frictions, class L>
void add_friction_laws(Group& group) {
  const std::vector<std::string> names = friction_names_of<Frictions, L>();
  if (names.size() < 2) return;
  std::string rules;
  std::vector<CatalogueField> fields;
  const std::vector<CatalogueField> common = contact().fields;
  for_each_friction_of<Frictions, L>([&]<class F>(const F& law) {
    rules += fmt::format("{}{} ({})", rules.empty() ? "" : ", or ", F::name, F::stiffness_rule);
    Group of_friction;
    add_fields(of_friction, law);
    for (CatalogueField& field : of_friction.fields) {
      if (!is_friction_field(field.name) ||
          std::ranges::find(common, field.name, &CatalogueField::name) != common.end())
        continue;
      field.with = "shear_law", field.with_value = F::name;
      fields.push_back(std::move(field));
    }
  });
  group.fields.push_back({.name = "shear_law",
                          .meaning = "tangential stiffness: " + rules,
                          .form = Form::name,
                          .names = names,
                          .absent = names.front()});
  set_with(group, "shear_law", "friction");
  group.fields.insert(group.fields.end(), fields.begin(), fields.end());
}

void add_contact_laws(std::vector<Group>& groups) {
  ContactLaws::for_each([&]<class L>(const L& law) {
    Group group{.id = fmt::format("contact {}", L::name),
                .head = fmt::format("[[contact]], law = \"{}\"", L::name),
                .base = "contact"};
    add_fields(group, law);
    if constexpr (HasEndRule<L>) group.fields.push_back(end_rule_field());
    if constexpr (HasHertzDashpot<L>) group.fields.push_back(dashpot_field(law.dashpot));
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
                                                             "with the dashpot constant, without effect on tsuji's"
                                                           : "speed of approach at which the restitution holds",
                                        dimension::velocity, Range::positive, ""));
        set_with(group, "restitution_speed", "restitution");
        if constexpr (!HasHertzDashpot<L>) require_with(group, "restitution_speed", "restitution");
      }
    }
    add_friction_laws<FrictionLaws, L>(group);
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
      quantity("interval", "time between rows of the history, at least the step; it limits a step that is \"auto\"",
               dimension::time, Range::positive, "a thousandth of the end, at least the step"),
      on_or_off("ledger", "energy and momentum balance of every step", "on"),
      table("watch", "what the run monitor does when it finds a limit exceeded", Form::table_or_off)};
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
                          .range = fmt::format("0 .. {}", maximum_seed),
                          .absent = "0"});
  groups.push_back(std::move(group));
  DiscLaws::for_each([&]<class L>(const L& law) {
    Group of_law{
        .id = fmt::format("cell {}", L::name), .head = fmt::format("[cell], law = \"{}\"", L::name), .base = "cell"};
    add_fields(of_law, law);
    of_law.fields.push_back(restitution_field());
    set_either(of_law, L::restitution_field.name, "restitution");
    if constexpr (HasEndRule<L>) of_law.fields.push_back(end_rule_field());
    if constexpr (HasHertzDashpot<L>) of_law.fields.push_back(dashpot_field(law.dashpot));
    if constexpr (!HasLinearPart<L>) {
      of_law.fields.push_back(quantity("impact_speed",
                                       "speed of approach for which restitution, contact time and stiffness are stated",
                                       dimension::velocity, Range::positive, "|block_speed|/(rows + 1)"));
    }
    add_friction_laws<DiscFrictions, L>(of_law);
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
  const std::vector<Group> of_fence = fence_field_groups();
  groups.insert(groups.end(), of_fence.begin(), of_fence.end());
  groups.push_back(cell_file());
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
