#include "solver/app/calibration/latching_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/app/calibration/impact_bodies.hpp"
#include "solver/app/calibration/value_lines.hpp"
#include "solver/base/error.hpp"
#include "solver/base/exit_code.hpp"
#include "solver/base/progress.hpp"
#include "solver/calibrate/latching_calibration.hpp"
#include "solver/io/file/quantity_text.hpp"

namespace talus::app {
namespace {

constexpr int phases = 200;

/// Result of a calibration; all values in SI units.
struct LatchingRatio {
  SteppedContact contact;
  double speed{};
  double by_formula{}, by_simulation{};
  SimulatedRestitution simulated;          ///< with the ratio by simulation
  SimulatedRestitution simulated_formula;  ///< with the ratio by formula

  double largest_overlap() const { return speed * contact.step / contact.loading_angle(); }
};

/// The step [s], from a text with unit or a bare number in s (control files of 1989 have no units).
double step_of(const std::string& text) {
  if (text.empty()) throw InputError{"--step: it is missing; give e.g. --step \"1e-7 s\""};
  double bare = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), bare);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size())
    return option_quantity("--step", text, dimension::time, si);
  if (!(bare > 0.0 && std::isfinite(bare))) throw InputError{fmt::format("--step: found \"{}\"; it must be > 0", text)};
  return bare;
}

constexpr double maximum_steps = 2e5;  ///< maximum number of steps in a simulated contact

void refuse_what_means_nothing(const CalibrateOptions& options) {
  if (options.masses.size() > 2) {
    throw InputError{
        "--masses: found three values, an axis of masses; of the law 'latching_spring' it must be one or two masses"};
  }
  constexpr std::array<std::string_view, 6> used{"--law",        "--speed", "--step",
                                                 "--integrator", "--units", "--stiffness"};
  for (const auto* options_given : {&options.own_to_impact, &options.own_to_range}) {
    for (const std::string& given : *options_given) {
      if (std::ranges::find(used, given) == used.end())
        throw InputError{fmt::format("{}: the law 'latching_spring' does not use this option; remove it", given)};
    }
  }
  static_cast<void>(demanded_restitution(options));
  const bool has_stiffness = !options.parameters.at("stiffness").empty();
  if (options.masses.empty() == has_stiffness) {
    throw InputError{fmt::format("{}: it is missing; give --masses and --stiffness, or neither for discs of ice",
                                 options.masses.empty() ? "--masses" : "--stiffness")};
  }
  if (options.masses.empty() && !(options.pivot.empty() && options.offset.empty()))
    throw InputError{"--masses: it is missing; --pivot and --offset describe body 2, whose mass is the last of them"};
}

LatchingRatio calibrated_ratio(const CalibrateOptions& options) {
  const ElapsedTime elapsed{"calibrating"};
  LatchingRatio found;
  found.contact = {option_quantity("--stiffness", options.parameters.at("stiffness"), dimension::stiffness, si),
                   effective_mass_of(options), step_of(options.step), make_disc_method(options.integrator)};
  found.speed = option_quantity("--speed", options.speed, dimension::velocity, si);
  try {
    found.by_formula = ratio_by_formula(found.contact, *options.restitution);
    if (const double steps = found.contact.steps_in_contact(found.by_formula); steps > maximum_steps) {
      throw InputError{
          fmt::format("step: found {} s, {:.3g} steps in a contact; it must be at least {:.3g} s: more than "
                      "{:g} steps take minutes to simulate, and hardly change the restitution",
                      found.contact.step, steps, 1.01 * found.contact.step * steps / maximum_steps, maximum_steps)};
    }
    found.by_simulation = ratio_by_simulation(found.contact, *options.restitution);
  } catch (const InputError& error) {
    throw InputError{fmt::format("--{}", error.what())};
  }
  found.simulated = simulated_restitution(found.contact, found.by_simulation, phases);
  found.simulated_formula = simulated_restitution(found.contact, found.by_formula, phases);
  return found;
}

void print_json(const LatchingRatio& found, const CalibrateOptions& options, bool default_discs) {
  const nlohmann::ordered_json json{{"law", options.law},
                                    {"integrator", options.integrator},
                                    {"default_discs", default_discs},
                                    {"effective_mass", found.contact.effective_mass},
                                    {"stiffness", found.contact.stiffness},
                                    {"unloading_stiffness", found.contact.stiffness / found.by_simulation},
                                    {"step", found.contact.step},
                                    {"loading_angle", found.contact.loading_angle()},
                                    {"steps_in_contact", found.contact.steps_in_contact(found.by_simulation)},
                                    {"ratio_by_formula", found.by_formula},
                                    {"ratio_by_simulation", found.by_simulation},
                                    {"restitution", found.simulated.mean},
                                    {"restitution_deviation", found.simulated.deviation},
                                    {"restitution_of_formula", found.simulated_formula.mean},
                                    {"phases", phases},
                                    {"exact_restitution", std::sqrt(found.by_simulation)},
                                    {"speed", found.speed},
                                    {"largest_overlap", found.largest_overlap()},
                                    {"units", "SI"}};
  fmt::print("{}\n", json.dump(2));
}

void print_text(const LatchingRatio& found, const CalibrateOptions& options, bool default_discs) {
  const UnitSystem units = unit_system(options.units);
  const ValueLines line{32, units};
  fmt::print("K1/K2 for a restitution of {} ({}, {})\n", *options.restitution, options.law, options.integrator);
  fmt::print("{}", bodies_text(options, units));
  line("effective mass", found.contact.effective_mass, dimension::mass);
  line("stiffness K1", found.contact.stiffness, dimension::stiffness);
  line("step h", found.contact.step, dimension::time);
  line("w1 h", found.contact.loading_angle(), dimension::number);
  line("steps in a contact", found.contact.steps_in_contact(found.by_simulation), dimension::number);
  line("K1/K2 by formula", found.by_formula, dimension::number);
  line("  restitution simulated with it", found.simulated_formula.mean, dimension::number);
  line("K1/K2 by simulation", found.by_simulation, dimension::number);
  line("  restitution simulated with it", found.simulated.mean, dimension::number);
  line("  its deviation between phases", found.simulated.deviation, dimension::number);
  line("  restitution of short steps", std::sqrt(found.by_simulation), dimension::number);
  line("  stiffness K2", found.contact.stiffness / found.by_simulation, dimension::stiffness);
  line("speed of approach", found.speed, dimension::velocity);
  line("largest overlap at that speed", found.largest_overlap(), dimension::length);
  fmt::print("  simulated: mean over {} phases of the step at which two discs touch\n", phases);
  if (default_discs)
    fmt::print("  discs of ice, 1 mm wide, are Talus's own choice; --masses and --stiffness take others\n");
}

}  // namespace

int calibrate_latching(CalibrateOptions options) {
  static_cast<void>(unit_system(options.units));
  refuse_what_means_nothing(options);
  const bool default_discs = options.masses.empty();
  if (default_discs) options.masses = {"7.2e-7 kg", "7.2e-7 kg"}, options.parameters["stiffness"] = "1.7e4 N/m";
  const LatchingRatio found = calibrated_ratio(options);
  if (options.json) {
    print_json(found, options, default_discs);
  } else {
    print_text(found, options, default_discs);
  }
  return ok;
}

}  // namespace talus::app
