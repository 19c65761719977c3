#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/base/fields.hpp"
#include "solver/base/units.hpp"
#include "solver/laws/law_list.hpp"

namespace talus::app {

/// A parameter of a contact law with its value.
struct LawParameter {
  std::string name;  ///< as in scenes
  double value{};
  Dimension dimension;
  Range range{};
  bool is_dissipation{};  ///< whether it sets the restitution
};

/// The value of an option for a parameter of a law, in SI units, or as a number without a unit. Errors: InputError
/// naming the option: no such value, or one outside the range.
[[nodiscard]] double parameter_value(const std::string& option, const std::string& text, Dimension dimension,
                                     Range range);

/// The parameters of a law, in the order of its fields.
[[nodiscard]] std::vector<LawParameter> parameters_of(const ContactLaw& law);

/// The parameter by which a law dissipates: damping or hysteresis; empty for laws without one.
[[nodiscard]] LawParameter dissipation_of(const ContactLaw& law);

/// The choices of a law, dashpot and end rule, by their names in scenes.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> choices_of(const ContactLaw& law);

/// "hertz, constant dashpot, clamped end rule"
[[nodiscard]] std::string law_text(const ContactLaw& law);

/// The lines of a law in a scene, with the parameters and choices in these units; parameters named in `of_pairs` are
/// comments.
[[nodiscard]] std::string scene_lines(const ContactLaw& law, const UnitSystem& units,
                                      const std::vector<std::string>& of_pairs = {});

/// A parameter as a line of a scene.
[[nodiscard]] std::string scene_line(const LawParameter& parameter, const UnitSystem& units);

/// Whether the restitution of the law depends on the speed (VariesRestitution).
[[nodiscard]] bool restitution_varies(const ContactLaw& law);

/// The law called `name`, without parameters. Errors: InputError if it is not known, or has no dashpot.
[[nodiscard]] ContactLaw law_named(const std::string& name);

/// The law of --law with its choices and the parameters of the options, in SI units. Parameters named in `of_pairs` are
/// given by the pairs of a range: their options must be absent. --spheres and --discs give the radius. The parameter by
/// which the law dissipates may be absent. Errors: InputError naming the option: one that the law does not use, is
/// missing, or has a wrong value.
[[nodiscard]] ContactLaw law_of_options(const CalibrateOptions& options, const std::vector<std::string>& of_pairs = {});

/// Whether the options give the parameter by which the law dissipates.
[[nodiscard]] bool gives_dissipation(const CalibrateOptions& options, const ContactLaw& law);

}  // namespace talus::app
