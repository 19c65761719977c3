#pragma once

#include "verification/check/findings.hpp"
#include "verification/study/program/program_options.hpp"

/// Rayleigh times of spheres; part of the case `calibrated_laws`.
namespace talus::verification::problems::calibrated_laws {

/// Compares Rayleigh times, materials and radii that the program finds for impacts of spheres, along the normal,
/// oblique and in ranges, with the exact surface wave. The names of all checks begin with "spheres: ".
void check_rayleigh_times(const Program& program, Findings& findings);

}  // namespace talus::verification::problems::calibrated_laws
