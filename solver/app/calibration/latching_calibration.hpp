#pragma once

#include "solver/app/calibration/calibrate_options.hpp"

namespace talus::app {

/// Executes `talus calibrate --law latching_spring`: K1/K2 for a restitution at a given step and method, by formula and
/// by simulation of two discs. Without --masses and --stiffness the discs are of ice, 1 mm in diameter: m = 7.2e-7 kg,
/// K1 = 1.7e4 N/m (values chosen for Talus; whether the thesis of 1989 gives any is unknown). Returns the exit status.
/// Errors: InputError naming the option.
[[nodiscard]] int calibrate_latching(CalibrateOptions options);

}  // namespace talus::app
