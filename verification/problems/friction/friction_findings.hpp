#pragma once

#include "verification/check/case.hpp"
#include "verification/study/oblique_runs.hpp"

/// Parts of the case `friction`.
namespace talus::verification::problems {

/// Coefficient of friction of the contacts, unless a part says otherwise.
inline constexpr double mu = oblique_friction;

/// A disc that slides until it rolls, and bodies on slopes on both sides of the angle of friction.
void check_rolling(Findings& findings, const Setup& setup);
void check_slopes(Findings& findings, const Setup& setup);

/// Oblique impacts: sliding all through, sticking, and both; orders, energy.
void check_oblique_impacts(Findings& findings, const Setup& setup);

/// The slip rate after impacts of many obliquities and stiffnesses; grazing impacts, which gain no energy.
void check_rebounds(Findings& findings, const Setup& setup);
void check_grazing(Findings& findings, const Setup& setup);

/// A block drawn to and fro along a prescribed path.
void check_shear_loop(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
