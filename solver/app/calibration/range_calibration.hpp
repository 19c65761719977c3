#pragma once

#include "solver/app/calibration/calibrate_options.hpp"
#include "solver/draw/drawing.hpp"

namespace talus::app {

/// Whether the options give a range of pairs: --speeds, --radii or --pairs.
[[nodiscard]] bool gives_range(const CalibrateOptions& options);

/// `talus calibrate` for many pairs that share one dashpot: prints for each pair the dashpot that is exact for it, the
/// restitution that it gets with the common one, and the common one with the smallest largest deviation; --out writes
/// the table and sends its drawing to the sink. Errors: InputError naming the option, or file, line and column;
/// IoError.
[[nodiscard]] int calibrate_range(const CalibrateOptions& options, const DrawingSink& sink);

}  // namespace talus::app
