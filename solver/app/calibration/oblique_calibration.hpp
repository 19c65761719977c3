#pragma once

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/draw/drawing.hpp"

namespace talus::app {

/// `talus calibrate` for oblique impacts with friction: the parameter of the friction that a tangential restitution at
/// --angle requires, or the rebound with given parameters; with --angles a table of rebounds with the same parameters.
/// Prints them, a step for all these impacts and the lines for a scene; --out writes the table and sends its drawing to
/// the sink. Errors: InputError naming the option; IoError.
[[nodiscard]] int calibrate_oblique(const CalibrateOptions& options, const DrawingSink& sink);

}  // namespace talus::app
