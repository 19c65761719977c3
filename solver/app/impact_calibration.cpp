#include "solver/app/impact_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "solver/app/command.hpp"
#include "solver/app/impact_bodies.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/calibrate/impact.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/laws/restitution.hpp"

namespace talus::app {
namespace {

/// Result of a calibration; all values in SI units.
struct ImpactCalibration {
  ContactLaw law;
  double effective_mass{};
  double speed{};
  double restitution{};  ///< requested, or in closed form
  KnownImpact known;
  ImpactStep step;
};

/// A field of a law with its value, and whether it sets the restitution.
struct Parameter {
  std::string name;
  double value{};
  Dimension dimension;
  bool is_dissipation{};
};
std::vector<Parameter> parameters_of(const ContactLaw& contact_law) {
  std::vector<Parameter> found;
  std::visit(
      [&]<class L>(const L& law) {
        for (const auto& field : L::fields()) {
          bool is_dissipation = false;
          if constexpr (SetsEveryRestitution<L>) is_dissipation = field.name == L::restitution_field.name;
          found.push_back({std::string{field.name}, law.*field.member, field.dimension, is_dissipation});
        }
      },
      contact_law);
  return found;
}

template <class Enum>
Enum value_named(const std::string& option, const std::string& name) {
  const auto& list = Names<Enum>::list;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i] == name) return static_cast<Enum>(i);
  }
  throw unknown_name(option, name, {list.begin(), list.end()});
}

/// The value of an option, in SI units, or as a number without a unit. Errors: InputError.
double parameter_value(const std::string& option, const std::string& text, const auto& field) {
  if (!(field.dimension == dimension::number))
    return option_quantity(option, text, field.dimension, si, field.range == Range::positive);
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || !contains(field.range, value))
    throw InputError{fmt::format("{}: found \"{}\"; it must be a number {}", option, text, words(field.range))};
  return value;
}

/// Errors: InputError for an option that was given and that the law does not have.
template <class L>
void refuse_other_options(const CalibrateOptions& options) {
  const auto refuse = [](std::string_view option) {
    throw InputError{fmt::format("{}: the law '{}' does not use this option; remove it", option, L::name)};
  };
  for (const std::string& given : options.own_to_impact) {
    if (given == "--step") throw InputError{fmt::format("--step: it is found for the law '{}'; remove it", L::name)};
    if (given == "--end-rule" && !HasEndRule<L>) refuse(given);
    if (given == "--dashpot" && !HasHertzDashpot<L>) refuse(given);
  }
  for (const auto& [name, value] : options.parameters) {
    const auto fields = L::fields();
    const bool has = std::any_of(fields.begin(), fields.end(), [&](const auto& field) { return field.name == name; });
    if (!value.empty() && !has) refuse(option_name(name));
  }
}

/// The law with its parameters, and the dashpot that the options give or that the restitution requires.
template <class L>
L law_of(const CalibrateOptions& options, double effective_mass, double speed) {
  refuse_other_options<L>(options);
  L law;
  if constexpr (HasEndRule<L>) law.end_rule = value_named<EndRule>("--end-rule: end rule", options.end_rule);
  if constexpr (HasHertzDashpot<L>) law.dashpot = value_named<HertzDashpot>("--dashpot: dashpot", options.dashpot);
  bool is_given = false;
  for (const auto& field : L::fields()) {
    const std::string option = option_name(field.name), text = options.parameters.at(std::string{field.name});
    const bool is_dissipation = field.name == L::restitution_field.name;
    is_given = is_given || (is_dissipation && !text.empty());
    if (text.empty() && is_dissipation) continue;
    if (text.empty()) {
      throw InputError{fmt::format("{}: it is missing; give e.g. {} \"{}\"", option, option,
                                   fmt::format("1 {}", symbol(si, field.dimension)))};
    }
    law.*field.member = parameter_value(option, text, field);
  }
  if (is_given == options.restitution.has_value()) {
    throw InputError{fmt::format("--restitution: found {} of --restitution and {}; give one of the two",
                                 is_given ? "both" : "none", option_name(L::restitution_field.name))};
  }
  if (options.restitution) law.set_restitution(*options.restitution, effective_mass, speed);
  return law;
}

/// Calls visit(L{}) for the law L of --law. Errors: InputError if it is not known, or has no dashpot.
template <class Visit>
void visit_law(const std::string& name, Visit&& visit) {
  bool is_known = false;
  ContactLaws::for_each([&]<class L>(const L& law) {
    if constexpr (SetsEveryRestitution<L>) {
      if (L::name == name) is_known = true, visit(law);
    }
  });
  if (!is_known) throw unknown_name("--law: law", name, ContactLaws::names());
}

ImpactCalibration calibrated(const CalibrateOptions& options) {
  const ElapsedTime elapsed{"calibrating"};
  ImpactCalibration found;
  visit_law(options.law, [&]<class L>(const L&) {
    if (options.masses.empty())
      throw InputError{"--masses: it is missing; give one or two, e.g. --masses \"2 kg\" \"1 kg\""};
    found.effective_mass = effective_mass_of(options);
    found.speed = option_quantity("--speed", options.speed, dimension::velocity, si);
    const L law = law_of<L>(options, found.effective_mass, found.speed);
    found.law = law;
    found.known = known_impact(law, found.effective_mass, found.speed);
    found.restitution = options.restitution.value_or(found.known.restitution);
  });
  found.step = advise_impact_step(found.law, found.effective_mass, found.speed, options.bound,
                                  make_integrator(options.integrator));
  return found;
}

/// The damping ratio of the impact, for laws that have one.
std::optional<double> damping_ratio_of(const ImpactCalibration& found) {
  return std::visit(
      [&]<class L>(L law) -> std::optional<double> {
        if constexpr (HasDampingRatio<L>) {
          law.set_every_restitution(found.restitution, found.speed);
          return law.damping_ratio;
        }
        return {};
      },
      found.law);
}

/// The choices of the law, by their names in scenes.
std::vector<std::pair<std::string, std::string>> choices_of(const ContactLaw& contact_law) {
  std::vector<std::pair<std::string, std::string>> found;
  std::visit(
      [&]<class L>(const L& law) {
        if constexpr (HasHertzDashpot<L>) found.emplace_back("dashpot", name_of(law.dashpot));
        if constexpr (HasEndRule<L>) found.emplace_back("end_rule", name_of(law.end_rule));
      },
      contact_law);
  return found;
}

bool varies(const ContactLaw& law) {
  return std::visit([](const auto& of) { return restitution_varies(of); }, law);
}

void print_json(const ImpactCalibration& found, const CalibrateOptions& options) {
  nlohmann::ordered_json json{{"law", options.law}};
  for (const Parameter& parameter : parameters_of(found.law))
    json[parameter.name] = parameter.value;
  for (const auto& [name, value] : choices_of(found.law))
    json[name] = value;
  if (const auto xi = damping_ratio_of(found)) json["damping_ratio"] = *xi;
  json["effective_mass"] = found.effective_mass;
  json["contact_time"] = found.known.contact_time;
  json["speed"] = found.speed;
  json["largest_overlap"] = found.known.largest_overlap;
  json["exact_restitution"] = found.restitution;
  json["step"] = found.step.step;
  json["restitution"] = found.step.restitution;
  json["restitution_error"] = found.step.largest_error;
  json["units"] = "SI";
  fmt::print("{}\n", json.dump(2));
}

void print_text(const ImpactCalibration& found, const CalibrateOptions& options) {
  const UnitSystem units = unit_system(options.units);
  const auto line = [&units](std::string_view what, double in_si, Dimension dimension) {
    fmt::print("  {:<32}{:>16.9g} {}\n", what, in_si / si_size(units, dimension), symbol(units, dimension));
  };
  const std::vector<Parameter> parameters = parameters_of(found.law);
  const Parameter& dissipation = *std::ranges::find(parameters, true, &Parameter::is_dissipation);
  std::string choices;
  for (const auto& [name, value] : choices_of(found.law))
    choices += fmt::format(", {} {}", value, name == "end_rule" ? "end rule" : name);
  if (options.restitution) {
    fmt::print("{} for a restitution of {} ({}{})\n", dissipation.name, *options.restitution, options.law, choices);
  } else {
    fmt::print("restitution with this {} ({}{})\n", dissipation.name, options.law, choices);
  }
  fmt::print("{}", bodies_text(options, units));
  line("effective mass", found.effective_mass, dimension::mass);
  line(dissipation.name == "damping" ? "damping c" : dissipation.name, dissipation.value, dissipation.dimension);
  if (const auto xi = damping_ratio_of(found)) line("damping ratio xi", *xi, dimension::number);
  line("restitution, exact", found.restitution, dimension::number);
  line("contact time", found.known.contact_time, dimension::time);
  line("speed of approach", found.speed, dimension::velocity);
  line("largest overlap at that speed", found.known.largest_overlap, dimension::length);
  line("step", found.step.step, dimension::time);
  line("restitution simulated with it", found.step.restitution, dimension::number);
  fmt::print("  simulated with {}; its error over all phases of the step is at most {:.3g}, required {:.3g}\n",
             options.integrator, found.step.largest_error, options.bound);
  if (varies(found.law)) fmt::print("  the restitution holds at this speed: others are more or less elastic\n");
  fmt::print("in a scene, for these bodies and this line of impact:\n");
  if (options.law != LinearSpringDashpot::name) fmt::print("  law = \"{}\"\n", options.law);
  for (const Parameter& parameter : parameters) {
    if (parameter.dimension == dimension::number) {
      fmt::print("  {} = {:.17g}\n", parameter.name, parameter.value);
    } else {
      fmt::print("  {} = \"{:.17g} {}\"\n", parameter.name, parameter.value / si_size(units, parameter.dimension),
                 symbol(units, parameter.dimension));
    }
  }
  for (const auto& [name, value] : choices_of(found.law))
    fmt::print("  {} = \"{}\"\n", name, value);
  if (!options.restitution) return;
  const std::string at_speed = varies(found.law) ? fmt::format(", restitution_speed = \"{:.17g} {}\"",
                                                               found.speed / si_size(units, dimension::velocity),
                                                               symbol(units, dimension::velocity))
                                                 : "";
  fmt::print("for every impact, whatever the bodies: restitution = {}{} in place of {}\n", *options.restitution,
             at_speed, dissipation.name);
}

}  // namespace

int calibrate_impact(const CalibrateOptions& options) {
  static_cast<void>(unit_system(options.units));
  const ImpactCalibration found = calibrated(options);
  if (options.json) {
    print_json(found, options);
  } else {
    print_text(found, options);
  }
  return ok;
}

}  // namespace talus::app
