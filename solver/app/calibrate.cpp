#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "solver/app/calibrate_options.hpp"
#include "solver/app/command.hpp"
#include "solver/app/latching_calibration.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::app {
namespace {

/// Result of a calibration without a scene; all values in SI units.
struct ImpactCalibration {
  LinearSpringDashpot law;
  double effective_mass{};
  double damping_ratio{};
  double speed{};
  ImpactStep step;
};

EndRule end_rule_named(const std::string& name) {
  const auto& list = Names<EndRule>::list;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i] == name) return static_cast<EndRule>(i);
  }
  throw unknown_name("end rule", name, {list.begin(), list.end()});
}

ImpactCalibration calibrated(const CalibrateOptions& options) {
  const ElapsedTime elapsed{"calibrating"};
  if (options.masses.empty())
    throw InputError{"--masses: it is missing; give one or two, e.g. --masses \"2 kg\" \"1 kg\""};
  if (options.stiffness.empty()) throw InputError{"--stiffness: it is missing; give e.g. --stiffness \"1e5 N/m\""};
  ImpactCalibration result;
  result.law.end_rule = end_rule_named(options.end_rule);
  result.law.stiffness = option_quantity("--stiffness", options.stiffness, dimension::stiffness, si);
  result.speed = option_quantity("--speed", options.speed, dimension::velocity, si);
  result.effective_mass = effective_mass_of(options);
  result.damping_ratio = damping_ratio(options.restitution, result.law.end_rule);
  result.law.damping = damping(result.damping_ratio, result.law.stiffness, result.effective_mass);
  result.step =
      advise_impact_step(result.law, result.effective_mass, options.bound, make_integrator(options.integrator));
  return result;
}

void print_json(const ImpactCalibration& found) {
  const nlohmann::ordered_json json{{"damping", found.law.damping},
                                    {"damping_ratio", found.damping_ratio},
                                    {"effective_mass", found.effective_mass},
                                    {"contact_time", found.law.contact_time(found.effective_mass)},
                                    {"speed", found.speed},
                                    {"largest_overlap", found.law.largest_overlap(found.effective_mass, found.speed)},
                                    {"step", found.step.step},
                                    {"restitution", found.step.restitution},
                                    {"restitution_error", found.step.largest_error},
                                    {"end_rule", Names<EndRule>::list[static_cast<std::size_t>(found.law.end_rule)]},
                                    {"units", "SI"}};
  fmt::print("{}\n", json.dump(2));
}

void print_text(const ImpactCalibration& found, const CalibrateOptions& options) {
  const UnitSystem units = unit_system(options.units);
  const auto line = [&units](std::string_view what, double in_si, Dimension dimension) {
    fmt::print("  {:<32}{:>16.9g} {}\n", what, in_si / si_size(units, dimension), symbol(units, dimension));
  };
  fmt::print("damping for a restitution of {} ({} end rule)\n", options.restitution, options.end_rule);
  line("effective mass", found.effective_mass, dimension::mass);
  line("damping c", found.law.damping, dimension::damping);
  line("damping ratio xi", found.damping_ratio, dimension::number);
  line("contact time", found.law.contact_time(found.effective_mass), dimension::time);
  line("speed of approach", found.speed, dimension::velocity);
  line("largest overlap at that speed", found.law.largest_overlap(found.effective_mass, found.speed),
       dimension::length);
  line("step", found.step.step, dimension::time);
  line("restitution simulated with it", found.step.restitution, dimension::number);
  fmt::print("  simulated with {}; its error over all phases of the step is at most {:.3g}, required {:.3g}\n",
             options.integrator, found.step.largest_error, options.bound);
  const auto in_units = [&units](double in_si, Dimension dimension) {
    return fmt::format("\"{:.17g} {}\"", in_si / si_size(units, dimension), symbol(units, dimension));
  };
  fmt::print(
      "in a scene, for these bodies and this line of impact:\n  stiffness = {}\n  damping = {}\n  end_rule = \"{}\"\n",
      in_units(found.law.stiffness, dimension::stiffness), in_units(found.law.damping, dimension::damping),
      options.end_rule);
  fmt::print("for every impact, whatever the bodies: restitution = {} in place of damping\n", options.restitution);
}

int calibrate_impact(const CalibrateOptions& options) {
  static_cast<void>(unit_system(options.units));
  const ImpactCalibration found = calibrated(options);
  if (options.json) {
    print_json(found);
  } else {
    print_text(found, options);
  }
  return ok;
}

ContactId contact_named(const Model& model, const std::string& name) {
  std::vector<std::string> known;
  for (const Contact& contact : model.contacts)
    known.push_back(contact.name);
  if (known.empty()) throw InputError{"--contact: the scene has no contact to calibrate"};
  if (name.empty()) throw unknown_name("--contact: contact", name, known);
  if (const auto found = find_contact(model, name)) return *found;
  throw unknown_name("--contact: contact", name, known);
}

/// Damping ratio of a contact's first law instance.
double damping_ratio_of(const Scene& scene, ContactId contact) {
  const Dynamics dynamics{scene.model};
  const std::vector<std::size_t>& instances = dynamics.layout().contact_instances;
  const auto first = std::accumulate(instances.begin(), instances.begin() + static_cast<long>(index(contact)), 0UL);
  return advise_step(dynamics, scene.initial).springs[first].damping_ratio;
}

/// The end rule of a law with a dashpot; laws without one cannot be calibrated.
EndRule end_rule_of(const ContactLaw& contact_law) {
  return std::visit(
      []<class L>(const L& law) {
        if constexpr (HasEndRule<L>) return law.end_rule;
        return EndRule{};
      },
      contact_law);
}

/// Calibration of a contact of a scene, in the scene's units.
struct SceneCalibration {
  Calibration found;
  Impact impact;  ///< the first impact with the calibrated damping
  double damping_ratio{};
  EndRule end_rule{};
};

void print_json(const SceneCalibration& result, const Scene& scene, const std::string& contact) {
  const UnitSystem& units = scene.model.units;
  const nlohmann::ordered_json json{
      {"contact", contact},
      {"damping", result.found.damping * si_size(units, dimension::damping)},
      {"damping_ratio", result.damping_ratio},
      {"contact_time", result.impact.contact_time},
      {"largest_overlap", result.impact.largest_overlap * si_size(units, dimension::length)},
      {"step", scene.plan.step},
      {"restitution", result.found.restitution},
      {"end_rule", Names<EndRule>::list[static_cast<std::size_t>(result.end_rule)]},
      {"runs", result.found.runs},
      {"units", "SI"}};
  fmt::print("{}\n", json.dump(2));
}

void print_text(const SceneCalibration& result, const Scene& scene, const std::string& contact) {
  const UnitSystem& units = scene.model.units;
  const auto line = [&units](std::string_view what, double value, Dimension dimension) {
    fmt::print("  {:<18}{:>16.9g} {}\n", what, value, symbol(units, dimension));
  };
  fmt::print("{}: contact '{}' calibrated by {} runs of the scene with {}\n", scene.title, contact, result.found.runs,
             name(scene.integrator));
  line("damping c", result.found.damping, dimension::damping);
  line("damping ratio xi", result.damping_ratio, dimension::number);
  line("restitution", result.found.restitution, dimension::number);
  line("contact time", result.impact.contact_time, dimension::time);
  line("largest overlap", result.impact.largest_overlap, dimension::length);
  line("step", scene.plan.step, dimension::time);
  fmt::print("in the scene:\n  damping = \"{:.17g} {}\"\n  end_rule = \"{}\"\n", result.found.damping,
             symbol(units, dimension::damping), Names<EndRule>::list[static_cast<std::size_t>(result.end_rule)]);
}

int calibrate_scene(const CalibrateOptions& options) {
  const Scene scene = read_scene(std::filesystem::path{options.scene});
  if (options.contact.empty()) throw InputError{"--contact: it is missing; name a contact of the scene"};
  const ContactId contact = contact_named(scene.model, options.contact);
  SceneCalibration result;
  std::optional<ElapsedTime> elapsed{std::in_place, "calibrating"};
  result.found = calibrate(scene, contact, options.restitution);
  const Scene damped = with_damping(scene, contact, result.found.damping);
  result.impact = simulate_impact(damped, contact);
  elapsed.reset();
  result.damping_ratio = damping_ratio_of(damped, contact);
  result.end_rule = end_rule_of(scene.model.contacts[index(contact)].law);
  if (options.json) {
    print_json(result, scene, options.contact);
  } else {
    print_text(result, scene, options.contact);
  }
  return ok;
}

/// Calibration without a scene, by the law of --law; rejects options that do not apply to the law.
int calibrate_law(const CalibrateOptions& options) {
  if (options.law == LatchingSpring::name) return calibrate_latching(options);
  if (options.law != LinearSpringDashpot::name)
    throw unknown_name("--law: law", options.law,
                       {std::string{LinearSpringDashpot::name}, std::string{LatchingSpring::name}});
  if (!options.step.empty()) throw InputError{"--step: it is found for the law 'linear_spring_dashpot'; leave it out"};
  return calibrate_impact(options);
}

int run_calibration(const CalibrateOptions& options) {
  if (!(options.restitution > 0.0 && options.restitution <= 1.0)) {
    throw InputError{fmt::format("--restitution: found {}; it must be in (0, 1]", options.restitution)};
  }
  if (options.scene.empty()) {
    if (!options.contact.empty()) throw InputError{"--contact: it needs a scene; name its file"};
    return calibrate_law(options);
  }
  if (!options.masses.empty() || !options.stiffness.empty() || !options.pivot.empty() || !options.offset.empty()) {
    throw InputError{"--masses, --stiffness, --pivot and --offset are the scene's own; leave them out"};
  }
  if (!options.own_to_impact.empty()) {
    throw InputError{fmt::format("{}: a scene has its own; leave it out", fmt::join(options.own_to_impact, ", "))};
  }
  return calibrate_scene(options);
}

}  // namespace

double effective_mass_of(const CalibrateOptions& options) {
  std::vector<ContactSide> sides;
  for (const std::string& mass : options.masses)
    sides.push_back({option_quantity("--masses", mass, dimension::mass, si), {}, 0.0, false});
  const bool pinned = !options.pivot.empty();
  const std::vector<std::string>& turning = pinned ? options.pivot : options.offset;
  if (!turning.empty()) {
    const std::string option = pinned ? "--pivot" : "--offset";
    sides.back().inertia = option_quantity(option, turning[0], dimension::inertia, si);
    sides.back().arm = option_quantity(option, turning[1], dimension::length, si);
    sides.back().pinned = pinned;
  }
  // A single body hits a fixed one: its effective mass is twice that against its own mirror image.
  return sides.size() == 1 ? 2.0 * effective_mass(sides[0], sides[0]) : effective_mass(sides[0], sides[1]);
}

Command add_calibrate(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("calibrate", "Find the damping, or K1/K2, that gives a contact its restitution");
  const auto options = std::make_shared<CalibrateOptions>();
  app->add_option("SCENE", options->scene, "scene file: calibrate its --contact by simulation of the scene");
  app->add_option("--contact", options->contact, "name of the scene's contact");
  app->add_option("--restitution", options->restitution, "restitution wanted, in (0, 1]")->required();
  app->add_option("--law", options->law,
                  "linear_spring_dashpot (default), or latching_spring: K1/K2 of two discs that are stepped by --step");
  app->add_option("--masses", options->masses, "mass of one body (against a wall) or of two")->expected(1, 2);
  app->add_option("--stiffness", options->stiffness, "stiffness of the contact, e.g. \"1e6 lbf/ft\"");
  app->add_option("--end-rule", options->end_rule,
                  "clamped (default, as in scenes: never pulls) or attractive (Eq. 21 of 1993)");
  CLI::Option* pivot = app->add_option("--pivot", options->pivot,
                                       "the last body turns about a pin: its inertia about the "
                                       "pin, and the arm from pin to the contact's normal")
                           ->expected(2);
  app->add_option("--offset", options->offset,
                  "the last body is free and hit off centre: its inertia about the centre, and the arm of the normal")
      ->expected(2)
      ->excludes(pivot);
  app->add_option("--speed", options->speed, "speed of approach for the overlap; default \"1 m/s\"");
  app->add_option("--bound", options->bound, "error of the restitution that the step may cause; default 0.001");
  app->add_option("--integrator", options->integrator, "method for the step; default velocity_verlet");
  app->add_option("--step", options->step, "of a latching_spring: its step, e.g. \"1e-7 s\"; a bare number is in s");
  app->add_option("--units", options->units, "SI or US, for the text; JSON is always SI");
  app->add_flag("--json", options->json, "print JSON, in SI units");
  app->footer(
      "Examples:\n"
      "  talus calibrate --restitution 0.5 --masses \"37.23 slug\" \"14.92 slug\" --stiffness \"1e6 lbf/ft\" --units "
      "US\n"
      "  talus calibrate --restitution 0.5 --masses \"37.23 slug\" \"14.92 slug\" --stiffness \"1e6 lbf/ft\" \\\n"
      "        --pivot \"324.14 slug ft^2\" \"4 ft\" --end-rule attractive\n"
      "  talus calibrate cases/pivoted_cylinder.toml --contact impact --restitution 0.5\n"
      "  talus calibrate --law latching_spring --restitution .7 --step 1e-7 --integrator euler");
  return {
      app, [app, options] {
        for (const char* name : {"--law", "--end-rule", "--speed", "--step", "--bound", "--integrator", "--units"}) {
          if (app->get_option(name)->count() > 0) options->own_to_impact.emplace_back(name);
        }
        return run_calibration(*options);
      }};
}

}  // namespace talus::app
