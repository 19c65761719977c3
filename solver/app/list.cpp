#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/app/field_list.hpp"
#include "solver/base/error.hpp"
#include "solver/base/units.hpp"
#include "solver/integrate/integrator_list.hpp"
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
