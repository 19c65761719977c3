#pragma once

#include <nlohmann/json_fwd.hpp>

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/laws/law_list.hpp"

namespace talus::app {

/// Returns the law with the dashpot that --restitution requires of an impact of this effective mass [kg] and speed of
/// approach [m/s], unless the options give the dashpot. Errors: InputError if both or none are given.
[[nodiscard]] ContactLaw damped_law(const CalibrateOptions& options, ContactLaw law, double effective_mass,
                                    double speed);

/// A single impact without a scene: the dashpot for a restitution, or the restitution of a dashpot, and a step: what
/// `talus calibrate --json` prints, in SI units. Errors: InputError naming the option.
[[nodiscard]] nlohmann::ordered_json impact_calibration(const CalibrateOptions& options);

/// `talus calibrate` for a law with a dashpot, without a scene: the dashpot for a restitution, or the restitution of a
/// dashpot; prints it and the lines for a scene. Errors: InputError naming the option.
[[nodiscard]] int calibrate_impact(const CalibrateOptions& options);

}  // namespace talus::app
