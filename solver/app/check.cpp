#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "solver/app/cell/cell_summary.hpp"
#include "solver/app/check/scene_check.hpp"
#include "solver/app/command.hpp"
#include "solver/app/outputs/output_size.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/command_line/shell_word.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/stability/contact_range.hpp"
#include "solver/stability/missing_contacts.hpp"
#include "solver/stability/start_overlaps.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::app {
namespace {

/// Maximum number of printed lines of a table.
constexpr std::size_t maximum_lines = 100;

/// The items of a list that are printed: the first `maximum_lines`.
template <class Item>
std::span<const Item> shown(const std::vector<Item>& items) {
  return std::span{items}.first(std::min(items.size(), maximum_lines));
}

void print_rest(std::size_t count) {
  if (count > maximum_lines) fmt::print("  ... and {} more\n", count - maximum_lines);
}

/// Prints the pairs of bodies that pass through each other: their number and the first three.
void print_missing_contacts(const MissingContacts& missing, const Scene& scene) {
  if (missing.size() == 0) return;
  if (missing.is_too_large())
    return fmt::print("pairs of bodies without a contact: more than {}\n", MissingContacts::maximum_pairs);
  constexpr std::size_t maximum_named = 3;
  std::vector<std::string> names;
  for (const Candidate& pair : std::span{missing.pairs()}.first(std::min(missing.size(), maximum_named))) {
    names.push_back(
        fmt::format("'{}' and '{}'", scene.model.bodies[index(pair.a)].name, scene.model.bodies[index(pair.b)].name));
  }
  fmt::print("pairs of bodies without a contact {}, which pass through each other: {}{}\n", missing.size(),
             fmt::join(names, ", "), missing.size() > maximum_named ? ", ..." : "");
}

void print_bodies(const Scene& scene, const Dynamics& dynamics) {
  const UnitSystem& units = scene.model.units;
  const Layout& layout = dynamics.layout();
  fmt::print("bodies {}, degrees of freedom {}\n", scene.model.bodies.size(), layout.coordinates.size());
  for (const Body& body : shown(scene.model.bodies)) {
    const std::string_view shape = std::visit([](const auto& s) { return s.name; }, body.shape);
    const std::string mass = body.mobility == Mobility::fixed
                                 ? ""
                                 : fmt::format(", mass {:.6g} {}", body.mass, symbol(units, dimension::mass));
    fmt::print("  {:<14} {}, shape {}{}\n", body.name, name_of(body.mobility), shape, mass);
  }
  print_rest(scene.model.bodies.size());
  std::size_t contact_instances = 0;
  for (const std::size_t count : layout.contact_instances)
    contact_instances += count;
  fmt::print("contact pairs possible {}, with {} law instances; cables {}\n", scene.model.contacts.size(),
             contact_instances, scene.model.cables.size());
  if (scene.plan.watch.missing_contacts != CheckAction::off) print_missing_contacts(MissingContacts{dynamics}, scene);
}

/// The number as text, or a dash if it is not finite (a spring between immobile bodies has infinite effective mass).
std::string number_or_dash(double value) { return std::isfinite(value) ? fmt::format("{:.5g}", value) : "-"; }

void print_springs(const Scene& scene, const StepAdvice& advice) {
  if (advice.springs.empty()) return fmt::print("no contacts and no cables\n");
  const UnitSystem& units = scene.model.units;
  fmt::print("  {:<14}{:>12}{:>12}{:>12}{:>12}{:>10}{:>14}{:>15}\n", "law", "k", "c", "m_eff", "frequency", "xi",
             "contact time", "steps/contact");
  fmt::print("  {:<14}{:>12}{:>12}{:>12}{:>12}{:>10}{:>14}{:>15}\n", "", symbol(units, dimension::stiffness),
             symbol(units, dimension::damping), symbol(units, dimension::mass),
             symbol(units, dimension::angular_velocity), "1", symbol(units, dimension::time), "1");
  for (const SpringAdvice& item : shown(advice.springs)) {
    fmt::print("  {:<14}{:>12.5g}{:>12.5g}{:>12}{:>12.5g}{:>10.4g}{:>14}{:>15}\n", item.name, item.spring.stiffness,
               item.spring.damping, number_or_dash(item.spring.effective_mass), item.frequency, item.damping_ratio,
               item.contact ? number_or_dash(item.contact_time) : "-",
               item.contact ? number_or_dash(item.contact_time / scene.plan.step) : "-");
  }
  print_rest(advice.springs.size());
}

void print_lighter_contacts(const Scene& scene, const std::vector<ContactRange>& lighter) {
  if (lighter.empty()) return;
  const UnitSystem& units = scene.model.units;
  fmt::print(
      "  The table holds for the position of the start. Bounds over all positions in which the bodies touch, the worst "
      "first:\n");
  fmt::print("  {:<14}{:>12}{:>12}{:>15}{:>14}{:>15}\n", "law", "m_eff min", "m_eff max", "frequency max",
             "contact time", "steps/contact");
  fmt::print("  {:<14}{:>12}{:>12}{:>15}{:>14}{:>15}\n", "", symbol(units, dimension::mass),
             symbol(units, dimension::mass), symbol(units, dimension::angular_velocity),
             fmt::format("min, {}", symbol(units, dimension::time)), "1");
  for (const ContactRange& range : shown(lighter)) {
    fmt::print("  {:<14}{:>12.5g}{:>12}{:>15.5g}{:>14.5g}{:>15.5g}\n", scene.model.contacts[index(range.contact)].name,
               range.smallest_mass, number_or_dash(range.largest_mass), range.highest_frequency, range.shortest_time,
               range.shortest_time / scene.plan.step);
  }
  print_rest(lighter.size());
}

void print_step(const Scene& scene, const SceneCheck& found) {
  const StepAdvice& advice = *found.advice;
  const std::string time = symbol(scene.model.units, dimension::time);
  const double step = scene.plan.step;
  fmt::print("step {:.6g} {} with {}\n", step, time, name(scene.integrator));
  if (!scene.integrator_reason.empty()) fmt::print("  chosen, as {}\n", scene.integrator_reason);
  if (advice.modes.empty()) return fmt::print("  no spring limits it\n");
  const std::string per_time = symbol(scene.model.units, dimension::angular_velocity);
  fmt::print("  highest frequency of the scene, all contacts closed and all cables taut: {:.6g} {}, xi {:.4g}\n",
             advice.highest_frequency(), per_time, advice.modes.back().damping_ratio);
  fmt::print("  step x highest frequency: {:.4g}\n", step * advice.highest_frequency());
  if (const auto& limit = found.limit) {
    fmt::print(
        "  linear limit of the method: {:.4g}, a step of {:.6g} {}, by the mode of {:.6g} {} with xi {:.4g}; the step "
        "is "
        "{:.4g} of it{}\n",
        limit->product, limit->step, time, limit->mode.frequency, per_time, limit->mode.damping_ratio,
        step / limit->step, step > limit->step ? " - TOO LONG" : "");
  } else {
    fmt::print("  the method has no limit in closed form here; with a tolerance, or exact, it chooses its own steps\n");
  }
  const double shortest = found.shortest_contact;
  if (std::isfinite(shortest) && !located_events(scene.integrator)) {
    fmt::print("  shortest contact: {:.6g} {}, {:.4g} steps; one-sided contacts need some 50 for 1 % in restitution\n",
               shortest, time, shortest / step);
  }
}

/// Number of force evaluations in the first steps of a scene, on a copy of its state.
double pilot_evaluations(const Scene& scene, const Dynamics& dynamics, long steps) {
  RigidBodySystem system{dynamics, scene.plan.ledger};
  Integrator integrator = scene.integrator;
  State state = scene.initial;
  RunPlan plan = scene.plan;
  plan.end = static_cast<double>(steps) * plan.step;
  static_cast<void>(simulate(system, integrator, state, plan));
  return static_cast<double>(system.evaluations());
}

/// Force evaluations per step, after the method's starting phase.
double evaluations_per_step(const Scene& scene, const Dynamics& dynamics) {
  const ElapsedTime elapsed{"taking the first steps"};
  return (pilot_evaluations(scene, dynamics, 24) - pilot_evaluations(scene, dynamics, 16)) / 8.0;
}

/// Cost of a run with step control, as text. Its first steps are not representative, so the run is tried as a whole, up
/// to a limited number of evaluations.
std::string chosen_cost(const Scene& scene, const Dynamics& dynamics) {
  // About a second for a large scene.
  const auto coordinates = std::max(1L, static_cast<long>(dynamics.layout().coordinates.size()));
  const long maximum = std::clamp(1'000'000L / coordinates, 100L, 20'000L);
  RigidBodySystem system{dynamics, scene.plan.ledger};
  system.allow(maximum);
  Integrator integrator = scene.integrator;
  State state = scene.initial;
  double reached = state.t;
  const Observer observer = [&reached](const State& seen, const StepInfo&) { reached = seen.t; };
  try {
    const ElapsedTime elapsed{"trying the run"};
    const Outcome outcome = simulate(system, integrator, state, scene.plan, {&observer, 1}, [&](const State& seen) {
      return scene.early_end && talus::reached(*scene.early_end, scene.model, seen);
    });
    if (!outcome) return fmt::format("{} force evaluations, then {}", system.evaluations(), outcome.message);
    return fmt::format("{} force evaluations", system.evaluations());
  } catch (const TooManyEvaluations&) {
    const double part = (reached - scene.initial.t) / (scene.plan.end - scene.initial.t);
    return fmt::format("more than {} force evaluations: these reach {:.2g} % of the run", maximum, 100.0 * part);
  }
}

void print_cost(const Scene& scene, const Dynamics& dynamics) {
  const long steps = step_count(scene.plan);
  if (chooses_steps(scene.integrator)) {
    return fmt::print(
        "expected cost: {} outputs to {:.6g} {}, {}; each over {} degrees of freedom and {} law instances\n", steps,
        scene.plan.end, symbol(scene.model.units, dimension::time), chosen_cost(scene, dynamics),
        dynamics.layout().coordinates.size(), dynamics.layout().mode_count);
  }
  const double each = evaluations_per_step(scene, dynamics);
  fmt::print(
      "expected cost: {} steps to {:.6g} {}, about {:.3g} force evaluations a step, {:.3g} in all; each over {} "
      "degrees of freedom and {} law instances\n",
      steps, scene.plan.end, symbol(scene.model.units, dimension::time), each, each * static_cast<double>(steps),
      dynamics.layout().coordinates.size(), dynamics.layout().mode_count);
}

void print_overlaps(const Scene& scene, const Dynamics& dynamics) {
  const std::vector<StartOverlap> overlaps = start_overlaps(dynamics, scene.initial);
  if (overlaps.empty()) return;
  fmt::print("overlaps at the start {}\n", overlaps.size());
  for (const StartOverlap& overlap : shown(overlaps))
    fmt::print("  {}\n", overlap_text(overlap, scene.model));
  print_rest(overlaps.size());
}

/// Prints the expected output of --out; its errors become warnings.
void print_output(const SceneFile& file, const Dynamics& dynamics, const std::filesystem::path& name,
                  std::vector<std::string>& warnings) {
  try {
    const std::string early = file.scene.early_end ? ", less if it ends early" : "";
    fmt::print("expected output of --out: {}{}\n", output_size_text(expected_output(file, dynamics, name)), early);
  } catch (const InputError& error) {
    warnings.push_back(fmt::format("talus run --out refuses this file: {}", error.what()));
  }
}

int check(const std::string& file) {
  const std::filesystem::path path{file};
  const std::string text = read_text(path);
  if (describes_cell(text, path)) {
    fmt::print("{}", cell_check(read_cell(text, file, {})));
    return ok;
  }
  const SceneFile read = read_scene_text(text, path);
  const Scene& scene = read.scene;
  const Dynamics dynamics{scene.model};
  SceneCheck found = [&] {
    const ElapsedTime elapsed{"evaluating the frequencies"};
    return check_scene(read, dynamics, fmt::format("talus run {} --integrator auto", shell_word(file)));
  }();
  fmt::print("{}\n", scene.title);
  print_bodies(scene, dynamics);
  print_overlaps(scene, dynamics);
  if (found.advice) {
    print_springs(scene, *found.advice);
    print_lighter_contacts(scene, found.lighter);
    print_step(scene, found);
  } else {
    fmt::print("step {:.6g} {} with {}; frequencies are evaluated up to {} degrees of freedom\n", scene.plan.step,
               symbol(scene.model.units, dimension::time), name(scene.integrator), maximum_checked_coordinates);
  }
  print_cost(scene, dynamics);
  print_output(read, dynamics, path, found.warnings);
  for (const std::string& warning : found.warnings)
    print_failure(fmt::format("warning: {}", warning));
  return found.is_unusable ? unusable : ok;
}

}  // namespace

Command add_check(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand(
      "check", "Read a scene; print its parts, overlaps, step limits and the expected cost and output");
  const auto scene = std::make_shared<std::string>();
  app->add_option("SCENE", *scene, "scene file (.toml), deck of 1993 or CNTRL.DAT of 1989 (.DAT)")->required();
  app->footer(
      "Example:\n  talus check cases/pivoted_cylinder.toml\n"
      "The exit status is 7 if the step is beyond the linear limit of the method, unless the watch of\n"
      "the scene has quality = \"warning\", the default with rules = \"1993\"; and if bodies without a contact\n"
      "between them overlap at the start and its missing_contacts = \"error\" would end the run.");
  return {app, [scene] { return check(*scene); }};
}

}  // namespace talus::app
