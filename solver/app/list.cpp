#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/geometry/shape.hpp"
#include "solver/granular/cell_plan.hpp"
#include "solver/granular/disc_method.hpp"
#include "solver/granular/shear_cell.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/fence_names.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/laws/settled.hpp"
#include "solver/model/contact.hpp"
#include "solver/model/model.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::app {
namespace {

/// Calls visit(T{}) for each alternative T of a variant, in order.
template <class Variant, std::size_t I = 0, class Visit>
void for_each(Visit&& visit) {
  if constexpr (I < std::variant_size_v<Variant>) {
    visit(std::variant_alternative_t<I, Variant>{});
    for_each<Variant, I + 1>(visit);
  }
}

std::string dimension_words(Dimension dimension) {
  if (dimension == dimension::number) return words(dimension);
  return fmt::format("{}, e.g. {} or {}", words(dimension), symbol(si, dimension), symbol(us, dimension));
}

void print_field(std::string_view name, std::string_view meaning, Range range, Dimension dimension) {
  fmt::print("    {:<13} {}{}\n    {:<13}   {}\n", name, meaning,
             range == Range::any ? "" : fmt::format(" {}", words(range)), "", dimension_words(dimension));
}

template <class T>
void print_fields() {
  for (const auto& field : T::fields())
    print_field(field.name, field.meaning, field.range, field.dimension);
}

template <class T>
void print_counts() {
  for (const auto& field : T::counts())
    fmt::print("    {:<13} {}\n    {:<13}   a whole number, {} .. {}\n", field.name, field.meaning, "", field.least,
               field.most);
}

template <class Enum>
void print_names(std::string_view title) {
  fmt::print("  {:<17}", title);
  for (const std::string_view name : Names<Enum>::list)
    fmt::print(" {}", name);
  fmt::print("\n");
}

void print_watch() {
  for (const WatchRules::Choice& choice : WatchRules::choices())
    print_names<Breach>(fmt::format("watch.{}", choice.name));
}

void list_integrators() {
  fmt::print("integrators (order on smooth motion; step control by `tolerance`)\n");
  for_each<Integrator>([](const auto& integrator) {
    using T = std::decay_t<decltype(integrator)>;
    std::string_view control = "fixed step";
    if constexpr (requires { T::has_step_control; }) {
      if (T::has_step_control) control = T::needs_tolerance ? "needs a tolerance" : "fixed step, or a tolerance";
    }
    if (needs_closed_form(T::name)) {
      fmt::print("  {:<23} no error  where motion between events is linear: particles, discs on planes, no cables\n",
                 T::name);
    } else {
      fmt::print("  {:<23} order {}   {}\n", T::name, T::order, control);
    }
  });
  fmt::print("  {:<23} {} where it can be, else {} with the tolerance\n", automatic_integrator, Exact::name,
             StormerCowell::name);
}

template <class List>
void list_law_fields(std::string_view title) {
  fmt::print("{}\n", title);
  List::for_each([](const auto& law) {
    fmt::print("  {}\n", law.name);
    print_fields<std::decay_t<decltype(law)>>();
  });
}

void list_laws() {
  list_law_fields<ContactLaws>("contact laws");
  print_names<EndRule>("end_rule");
  print_names<ContactMethod>("method");
  list_law_fields<CableLaws>("cable laws");
}

void list_shapes() {
  fmt::print("shapes\n");
  for_each<Shape>([](const auto& shape) {
    fmt::print("  {}\n", shape.name);
    print_fields<std::decay_t<decltype(shape)>>();
  });
}

void list_units() {
  fmt::print(
      "units (joined by blanks, * and /, with whole powers: \"slug ft^2\", \"N s/m\"; lb is a mass, lbf a force)\n ");
  for (const std::string& symbol : unit_symbols())
    fmt::print(" {}", symbol);
  fmt::print("\nunit systems\n");
  for (const UnitSystem& system : {si, us})
    fmt::print("  {:<4} {}, {}, {}; force in {}\n", system.name, system.mass, system.length, system.time, system.force);
}

void list_fence_fields() {
  fmt::print(
      "[fence]    in place of bodies, contacts, cables and run: history_elements  history_codes  ground  rock  column\n"
      "           ground_profile  changed_column  stretched_cable  options, and (a name before a colon is that of the "
      "deck of 1993)\n");
  print_counts<scenes::Fence>();
  print_fields<scenes::Fence>();
  fmt::print("[fence.ground]  [[fence.rock]]  [fence.column]  solid  held  along, and\n");
  print_counts<scenes::FenceElement>();
  print_fields<scenes::FenceElement>();
  for (const auto& field : scenes::FenceElement::vectors())
    print_field(field.name, field.meaning, Range::any, field.dimension);
  print_names<scenes::ElementSolid>("solid");
  fmt::print("[[fence.changed_column]]\n");
  print_counts<scenes::ChangedColumn>();
  print_fields<scenes::ChangedColumn>();
  fmt::print("[[fence.stretched_cable]]  cable, and\n");
  print_fields<scenes::StretchedCable>();
  fmt::print("[fence.options] integrator  table  watch, and\n");
  print_fields<scenes::FenceOptions>();
  print_watch();
  for_each_choice(scenes::FenceOptions{},
                  [](std::string_view name, auto choice) { print_names<decltype(choice)>(name); });
}

void list_cell_fields() {
  fmt::print(
      "[cell]     law  restitution or the law's loss  friction  shear_stiffness  overburden or block_mass  seed, "
      "and\n");
  print_counts<ShearCell>();
  print_fields<ShearCell>();
  list_law_fields<DiscLaws>("  laws of a cell");
  print_names<EndRule>("end_rule");
  print_names<Images>("images");
  fmt::print("[run] of a cell  integrator  jump  images  historical  pictures (on or off), and\n");
  print_fields<CellPlan>();
  fmt::print("  integrator: {}\n", fmt::join(disc_method_names(), ", "));
}

void list_fields() {
  fmt::print(
      "file       title  units  gravity\n"
      "[[body]]   name  mobility  shape  position  pin  velocity  spin  force, and\n");
  print_fields<Body>();
  print_names<Mobility>("mobility");
  fmt::print(
      "[[contact]] name  between  law  end_rule  method  nodes  restitution  restitution_rule, and the law's fields\n"
      "[[cable]]  name  from  to  law  rest_length  slack, and the law's fields\n"
      "[run]      integrator  tolerance  step  end  interval  ledger  watch\n");
  print_watch();
  list_laws();
  list_shapes();
  list_fence_fields();
  list_cell_fields();
}

const std::vector<std::pair<std::string, void (*)()>>& topics() {
  static const std::vector<std::pair<std::string, void (*)()>> all{{"integrators", list_integrators},
                                                                   {"laws", list_laws},
                                                                   {"shapes", list_shapes},
                                                                   {"units", list_units},
                                                                   {"fields", list_fields}};
  return all;
}

int list(const std::string& wanted) {
  bool found = false;
  for (const auto& topic : topics()) {
    if (!wanted.empty() && topic.first != wanted) continue;
    if (wanted.empty() && topic.first == "fields") continue;  // those of laws and shapes stand there already
    topic.second();
    found = true;
  }
  if (found) return ok;
  std::vector<std::string> names;
  for (const auto& topic : topics())
    names.push_back(topic.first);
  throw unknown_name("topic", wanted, names);
}

}  // namespace

Command add_list(CLI::App& talus) {
  CLI::App* app =
      talus.add_subcommand("list", "What can be named in a scene: integrators, laws, shapes, units, fields");
  const auto topic = std::make_shared<std::string>();
  app->add_option("topic", *topic, "integrators, laws, shapes, units or fields; all but the last when left out");
  app->footer("Example:\n  talus list fields");
  return {app, [topic] { return list(*topic); }};
}

}  // namespace talus::app
