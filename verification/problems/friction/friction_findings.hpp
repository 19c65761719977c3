#pragma once

#include "verification/check/case.hpp"
#include "verification/study/impacts/oblique_runs.hpp"

/// Parts of the case `friction`.
namespace talus::verification::problems {

/// Coefficient of friction of the contacts, unless a part sets another.
inline constexpr double mu = oblique_friction;

/// Checks a disc that slides until it rolls, and bodies on slopes below and above the friction angle.
void check_rolling(Findings& findings, const Setup& setup);
void check_slopes(Findings& findings, const Setup& setup);

/// Checks oblique impacts that slide throughout, stick, or do both: orders and energy balance.
void check_oblique_impacts(Findings& findings, const Setup& setup);

/// Checks the slip rate after impacts of many obliquities and stiffnesses, and that grazing impacts gain no energy.
void check_rebounds(Findings& findings, const Setup& setup);
void check_grazing(Findings& findings, const Setup& setup);

/// Checks the hysteresis loop of a block drawn back and forth along a prescribed path.
void check_shear_loop(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
