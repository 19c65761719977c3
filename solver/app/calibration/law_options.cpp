#include "solver/app/calibration/law_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <variant>

#include "solver/app/calibration/impact_bodies.hpp"
#include "solver/base/error.hpp"
#include "solver/io/file/quantity_text.hpp"
#include "solver/laws/parameter.hpp"

namespace talus::app {
namespace {

/// Errors: InputError for an option that was given and that the law does not have.
template <class L>
void refuse_other_options(const CalibrateOptions& options) {
  const auto refuse = [](std::string_view option) {
    throw InputError{fmt::format("{}: the law '{}' does not use this option; remove it", option, L::name)};
  };
  const auto has = [](std::string_view name) {
    const auto fields = L::fields();
    return std::ranges::find(fields, name, &Field<L>::name) != fields.end();
  };
  for (const std::string& given : options.own_to_impact) {
    if (given == "--step") throw InputError{fmt::format("--step: it is found for the law '{}'; remove it", L::name)};
    if (given == "--end-rule" && !HasEndRule<L>) refuse(given);
    if (given == "--dashpot" && !HasHertzDashpot<L>) refuse(given);
    if (given == "--poisson-ratio" && !has("modulus")) refuse(given);
    if (given == "--spheres" && !has("radius") && !gives_oblique(options)) refuse(given);
  }
  for (const auto& [name, value] : options.parameters) {
    if (!value.empty() && !has(name)) refuse(option_name(name));
  }
}

template <class L>
void set_choices(L& law, const CalibrateOptions& options) {
  if constexpr (HasEndRule<L>) law.end_rule = value_named<EndRule>("--end-rule: end rule", options.end_rule);
  if constexpr (HasHertzDashpot<L>) law.dashpot = value_named<HertzDashpot>("--dashpot: dashpot", options.dashpot);
}

}  // namespace

double parameter_value(const std::string& option, const std::string& text, Dimension dimension, Range range) {
  const bool is_number = dimension == dimension::number;
  double value = 0.0;
  if (is_number) {
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc{} || read.ptr != text.data() + text.size())
      throw InputError{fmt::format("{}: found \"{}\"; it must be a number {}", option, text, text_of(range))};
  } else {
    value = option_quantity(option, text, dimension, si, false);
  }
  if (!contains(range, value)) {
    throw InputError{
        fmt::format("{}: found \"{}\"; it must be {}{}", option, text, is_number ? "a number " : "", text_of(range))};
  }
  return value;
}

std::vector<LawParameter> parameters_of(const ContactLaw& contact_law) {
  std::vector<LawParameter> found;
  std::visit(
      [&]<class L>(const L& law) {
        for (const auto& field : L::fields()) {
          bool is_dissipation = false;
          if constexpr (SetsEveryRestitution<L>) is_dissipation = field.name == L::restitution_field.name;
          found.push_back({std::string{field.name}, law.*field.member, field.dimension, field.range, is_dissipation});
        }
      },
      contact_law);
  return found;
}

LawParameter dissipation_of(const ContactLaw& law) {
  const std::vector<LawParameter> parameters = parameters_of(law);
  const auto found = std::ranges::find(parameters, true, &LawParameter::is_dissipation);
  return found == parameters.end() ? LawParameter{} : *found;
}

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

std::string law_text(const ContactLaw& contact_law) {
  std::string text = std::visit([]<class L>(const L&) { return std::string{L::name}; }, contact_law);
  for (const auto& [name, value] : choices_of(contact_law))
    text += fmt::format(", {} {}", value, name == "end_rule" ? "end rule" : name);
  return text;
}

std::string scene_line(const LawParameter& parameter, const UnitSystem& units) {
  const double value = parameter.value / si_size(units, parameter.dimension);
  if (parameter.dimension == dimension::number) return fmt::format("  {} = {}\n", parameter.name, value);
  return fmt::format("  {} = \"{} {}\"\n", parameter.name, value, symbol(units, parameter.dimension));
}

std::string scene_lines(const ContactLaw& law, const UnitSystem& units, const std::vector<std::string>& of_pairs) {
  std::string lines = std::visit([]<class L>(const L&) { return fmt::format("  law = \"{}\"\n", L::name); }, law);
  for (const LawParameter& parameter : parameters_of(law)) {
    const bool is_of_pairs = std::ranges::find(of_pairs, parameter.name) != of_pairs.end();
    lines += is_of_pairs ? fmt::format("  # {}: that of each pair\n", parameter.name) : scene_line(parameter, units);
  }
  for (const auto& [name, value] : choices_of(law))
    lines += fmt::format("  {} = \"{}\"\n", name, value);
  return lines;
}

bool restitution_varies(const ContactLaw& law) {
  return std::visit([](const auto& of) { return talus::restitution_varies(of); }, law);
}

ContactLaw law_named(const std::string& name) {
  ContactLaw found;
  bool is_known = false;
  ContactLaws::for_each([&]<class L>(const L& law) {
    if constexpr (SetsEveryRestitution<L>) {
      if (L::name == name) is_known = true, found = law;
    }
  });
  if (!is_known) throw unknown_name("--law: law", name, ContactLaws::names());
  return found;
}

ContactLaw law_of_options(const CalibrateOptions& options, const std::vector<std::string>& of_pairs) {
  ContactLaw found = law_named(options.law);
  std::visit(
      [&]<class L>(L& law) {
        refuse_other_options<L>(options);
        set_choices(law, options);
      },
      found);
  for (const LawParameter& parameter : parameters_of(found)) {
    const std::string option = option_name(parameter.name), text = options.parameters.at(parameter.name);
    const bool is_of_pairs = std::ranges::find(of_pairs, parameter.name) != of_pairs.end();
    const bool is_of_bodies = parameter.name == "radius" && gives_round_bodies(options);
    if ((is_of_pairs || is_of_bodies) && !text.empty()) {
      throw InputError{fmt::format("{}: {}; remove it", option,
                                   is_of_pairs ? "each pair gives its own" : "it follows from --spheres or --discs")};
    }
    if (is_of_bodies) {
      set_parameter(found, parameter.name, effective_radius(round_bodies(options)));
      continue;
    }
    if (text.empty() && (is_of_pairs || parameter.is_dissipation)) continue;
    if (text.empty()) {
      throw InputError{fmt::format("{}: it is missing; give e.g. {} \"{}\"", option, option,
                                   fmt::format("1 {}", symbol(si, parameter.dimension)))};
    }
    set_parameter(found, parameter.name, parameter_value(option, text, parameter.dimension, parameter.range));
  }
  return found;
}

bool gives_dissipation(const CalibrateOptions& options, const ContactLaw& law) {
  return !options.parameters.at(dissipation_of(law).name).empty();
}

}  // namespace talus::app
