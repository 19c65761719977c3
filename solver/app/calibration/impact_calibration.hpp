#pragma once

#include "solver/app/calibration/calibrate_options.hpp"

namespace talus::app {

/// `talus calibrate` for a law with a dashpot, without a scene: the dashpot for a restitution, or the restitution of a
/// dashpot; prints it and the lines for a scene. Errors: InputError naming the option.
[[nodiscard]] int calibrate_impact(const CalibrateOptions& options);

}  // namespace talus::app
