#pragma once

#include <string>
#include <vector>

#include "solver/app/calibration/law_options.hpp"

namespace talus::app {

/// The friction of an oblique impact.
struct GivenFriction {
  FrictionLaw law;
  std::string sought;  ///< the parameter that --tangential-restitution requires; empty: none
};

/// The friction of --shear-law with the parameters of the options, in SI units, for contacts of this law with its
/// parameters. With --tangential-restitution the first of friction, stiffness or modulus, and dashpot whose option is
/// absent is sought. Others that are absent have the defaults of scenes. Errors: InputError naming the option: one that
/// the law does not use, is missing, or has a wrong value; none is left to be sought.
[[nodiscard]] GivenFriction friction_of_options(const CalibrateOptions& options, const ContactLaw& contact_law);

/// The same law with a number in place of the dashpot that follows the damping of the contact's law.
[[nodiscard]] FrictionLaw with_explicit_dashpot(FrictionLaw friction, const ContactLaw& contact_law);

/// The parameters of a friction law that scenes give beside those of the contact's law.
[[nodiscard]] std::vector<LawParameter> parameters_of(const FrictionLaw& law);

/// Name of a friction law in scenes.
[[nodiscard]] std::string friction_name(const FrictionLaw& law);

/// Tangential over normal stiffness of a contact at an overlap > 0 [L].
[[nodiscard]] double stiffness_ratio(const FrictionLaw& friction, const ContactLaw& contact_law, double overlap);

}  // namespace talus::app
