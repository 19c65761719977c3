#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/app/field_list.hpp"
#include "solver/base/error.hpp"
#include "solver/base/units.hpp"
#include "solver/command_line/completion.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::app {
namespace {

void list_integrators() {
  fmt::print("integrators (order on smooth motion; step control by `tolerance`)\n");
  const auto order_and_control = [](const IntegratorTraits& traits) -> std::string {
    switch (traits.step_control) {
      case StepControl::fixed:
        return fmt::format("order {}   fixed step", traits.order);
      case StepControl::fixed_or_tolerance:
        return fmt::format("order {}   fixed step, or a tolerance", traits.order);
      case StepControl::tolerance:
        return fmt::format("order {}   needs a tolerance", traits.order);
      case StepControl::closed_form:
        break;
    }
    return "no error  where motion between events is linear: particles, discs on planes, no cables";
  };
  for (const std::string& name : integrator_names())
    fmt::print("  {:<23} {}\n", name, order_and_control(integrator_traits(name)));
  fmt::print("  {:<23} {} where it can be, else {} with the tolerance\n", automatic_integrator, Exact::name,
             StormerCowell::name);
}

void list_laws() {
  fmt::print("{}", field_list_legend());
  for (const char* const id : {"contact ", "cable ", "cell "}) {
    for (const FieldGroup& group : field_catalogue()) {
      if (group.id.starts_with(id) && group.head.find("law = ") != std::string::npos)
        fmt::print("{}", field_list(group));
    }
  }
}

void list_shapes() {
  fmt::print("{}", field_list_legend());
  for (const FieldGroup& group : field_catalogue()) {
    if (group.id.starts_with("shape")) fmt::print("{}", field_list(group));
  }
}

void list_units() {
  fmt::print(
      "units (combined with spaces, *, / and integer exponents: \"slug ft^2\", \"N s/m\"; lb is a mass, lbf a "
      "force)\n ");
  for (const std::string& symbol : unit_symbols())
    fmt::print(" {}", symbol);
  fmt::print("\nunit systems\n");
  for (const UnitSystem& system : {si, us})
    fmt::print("  {:<4} {}, {}, {}; force in {}\n", system.name, system.mass, system.length, system.time, system.force);
}

void list_fields() {
  fmt::print("{}", field_list_legend());
  for (const FieldGroup& group : field_catalogue())
    fmt::print("\n{}", field_list(group));
}

const std::vector<std::pair<std::string, void (*)()>>& topics() {
  static const std::vector<std::pair<std::string, void (*)()>> all{{"integrators", list_integrators},
                                                                   {"laws", list_laws},
                                                                   {"shapes", list_shapes},
                                                                   {"units", list_units},
                                                                   {"fields", list_fields}};
  return all;
}

std::vector<std::string> topic_names() {
  std::vector<std::string> names;
  for (const auto& topic : topics())
    names.push_back(topic.first);
  return names;
}

int list(const std::string& wanted) {
  bool found = false;
  for (const auto& topic : topics()) {
    if (!wanted.empty() && topic.first != wanted) continue;
    if (wanted.empty() && topic.first == "fields") continue;  // fields of laws and shapes are already listed
    topic.second();
    found = true;
  }
  if (found) return ok;
  throw unknown_name("topic", wanted, topic_names());
}

}  // namespace

Command add_list(CLI::App& talus) {
  CLI::App* app =
      talus.add_subcommand("list", "What can be named in a scene: integrators, laws, shapes, units, fields");
  const auto topic = std::make_shared<std::string>();
  offer(app->add_option("topic", *topic, "integrators, laws, shapes, units or fields; all but the last when left out"),
        topic_names());
  app->footer("Example:\n  talus list fields");
  return {app, [topic] { return list(*topic); }};
}

}  // namespace talus::app
