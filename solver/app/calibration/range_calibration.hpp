#pragma once

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/draw/drawing.hpp"

namespace talus::app {

/// Whether --masses is an axis: the first mass of body 2, the last one, and their number. Body 1 is fixed.
[[nodiscard]] bool gives_mass_axis(const CalibrateOptions& options);

/// Whether the options give a range of pairs: --speeds, --radii, --pairs or an axis of --masses.
[[nodiscard]] bool gives_range(const CalibrateOptions& options);

/// `talus calibrate` for many pairs that share one dashpot: prints for each pair the dashpot that is exact for it, the
/// restitution that it gets with the common one, the common one with the smallest largest deviation, and a step for all
/// pairs; --out writes the table and sends its drawing to the sink. Errors: InputError naming the option, or file, line
/// and column; IoError.
[[nodiscard]] int calibrate_range(const CalibrateOptions& options, const DrawingSink& sink);

}  // namespace talus::app
