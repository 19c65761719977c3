#include "solver/app/calibration/friction_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/calibrate/oblique_impact.hpp"
#include "solver/calibrate/rayleigh_time.hpp"
#include "solver/laws/parameter.hpp"

namespace talus::app {
namespace {

constexpr std::string_view shear_modulus = "shear_modulus";

/// The friction law F for contacts of law L, with the defaults of scenes and the values that are the contact's.
template <IsFrictionLaw F, class L>
F default_friction(const L& law, bool has_dashpot) {
  F friction{};
  if constexpr (FollowsNormal<F>) friction.follow(law.tangent().stiffness, HasRetardationTime<L> && !has_dashpot);
  for (const auto& field : F::fields()) {
    const auto fields = L::fields();
    const auto own = std::ranges::find(fields, field.name, &Field<L>::name);
    if (!is_friction_field(field.name) && own != fields.end()) friction.*field.member = law.*own->member;
  }
  return friction;
}

std::string example_of(const LawParameter& parameter) {
  if (parameter.dimension == dimension::number) return "0.3";
  return fmt::format("\"1 {}\"", symbol(si, parameter.dimension));
}

/// Whether the options give a parameter of the friction; Poisson's ratio gives a shear modulus.
bool gives(const CalibrateOptions& options, std::string_view name) {
  return !options.friction.at(std::string{name}).empty() || (name == shear_modulus && options.poisson_ratio);
}

/// The first parameter whose option is absent.
std::string first_absent(const CalibrateOptions& options, const std::vector<LawParameter>& parameters) {
  const auto absent =
      std::ranges::find_if(parameters, [&](const LawParameter& of) { return !gives(options, of.name); });
  if (absent != parameters.end()) return absent->name;
  throw InputError{
      fmt::format("{}: found with --tangential-restitution and all other parameters of the friction; leave "
                  "out the one to be found",
                  option_name(parameters.back().name))};
}

/// The law of --shear-law with the defaults of scenes. `has_dashpot`: its dashpot does not follow that of the contact.
FrictionLaw default_friction(const std::string& name, const ContactLaw& contact_law, bool has_dashpot) {
  FrictionLaw made;
  std::visit(
      [&]<class L>(const L& law) {
        const std::vector<std::string> names = friction_names_of<FrictionLaws, L>();
        if (std::ranges::find(names, name) == names.end())
          throw unknown_name(fmt::format("--shear-law: friction of {}", L::name), name, names);
        for_each_friction_of<FrictionLaws, L>([&]<class F>(const F&) {
          if (F::name == name) made = default_friction<F>(law, has_dashpot);
        });
      },
      contact_law);
  return made;
}

}  // namespace

GivenFriction friction_of_options(const CalibrateOptions& options, const ContactLaw& contact_law) {
  GivenFriction given{default_friction(options.shear_law, contact_law, false), {}};
  const std::vector<LawParameter> parameters = parameters_of(given.law);
  for (const auto& [name, text] : options.friction) {
    if (!text.empty() && std::ranges::find(parameters, name, &LawParameter::name) == parameters.end()) {
      throw InputError{fmt::format("{}: the friction law '{}' does not use this option; remove it", option_name(name),
                                   options.shear_law)};
    }
  }
  if (options.tangential_restitution) given.sought = first_absent(options, parameters);
  const bool has_dashpot = !options.friction.at("shear_damping").empty() || given.sought == "shear_damping";
  given.law = default_friction(options.shear_law, contact_law, has_dashpot);
  for (const LawParameter& parameter : parameters) {
    const std::string option = option_name(parameter.name), text = options.friction.at(parameter.name);
    const bool has_default = parameter.name != "friction" && contains(parameter.range, parameter.value);
    if (parameter.name == shear_modulus && options.poisson_ratio) {
      if (!text.empty())
        throw InputError{fmt::format("{}: it follows from --poisson-ratio; give one of the two", option)};
      const std::vector<LawParameter> normal = parameters_of(contact_law);
      const double modulus = std::ranges::find(normal, "modulus", &LawParameter::name)->value;
      set_parameter(given.law, parameter.name, material_of(modulus, *options.poisson_ratio).effective_shear_modulus());
    } else if (!text.empty()) {
      set_parameter(given.law, parameter.name, parameter_value(option, text, parameter.dimension, parameter.range));
    } else if (parameter.name != given.sought && !has_default) {
      throw InputError{fmt::format("{}: it is missing; give e.g. {} {}", option, option, example_of(parameter))};
    }
  }
  return given;
}

FrictionLaw with_explicit_dashpot(FrictionLaw friction, const ContactLaw& contact_law) {
  std::visit(
      [&]<class F, class L>(F& law, const L& normal) {
        if constexpr (FollowsNormal<F> && HasRetardationTime<L>) {
          law.damping = law.dashpot(normal.retardation_time({}));
          law.follows_normal = false;
        }
      },
      friction, contact_law);
  return friction;
}

std::vector<LawParameter> parameters_of(const FrictionLaw& friction) {
  std::vector<LawParameter> found;
  std::visit(
      [&]<class F>(const F& law) {
        for (const auto& field : F::fields())
          if (is_friction_field(field.name))
            found.push_back({std::string{field.name}, law.*field.member, field.dimension, field.range, false});
      },
      friction);
  return found;
}

std::string friction_name(const FrictionLaw& friction) {
  return std::visit([]<class F>(const F&) { return std::string{F::name}; }, friction);
}

double stiffness_ratio(const FrictionLaw& friction, const ContactLaw& contact_law, double overlap) {
  constexpr double difference = 1e-6;
  const double normal = std::visit(
      [&](const auto& law) {
        const auto force = [&](double at) { return law(Kinematics{at, 0.0}, {}, 1).elastic; };
        return (force(overlap * (1.0 + difference)) - force(overlap * (1.0 - difference))) /
               (2.0 * difference * overlap);
      },
      contact_law);
  return at(friction, overlap).stiffness / normal;
}

}  // namespace talus::app
