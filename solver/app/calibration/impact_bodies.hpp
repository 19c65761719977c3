#pragma once

#include <string>

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/base/units.hpp"

namespace talus::app {

/// Effective mass of an impact of two bodies along the line of impact [kg], from --masses, --pivot and --offset.
/// Body 2 is the last of --masses, to which --pivot or --offset applies; with one mass it is the only moving one, and
/// body 1 is fixed. Errors: InputError naming the option.
[[nodiscard]] double effective_mass_of(const CalibrateOptions& options);

/// Lines of text that give each body its role in the impact and its effective mass, in these units. Errors: as above.
[[nodiscard]] std::string bodies_text(const CalibrateOptions& options, const UnitSystem& units);

}  // namespace talus::app
