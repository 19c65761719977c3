#pragma once

#include "verification/check/case.hpp"

/// Checks of effective masses in the case `restitution`.
namespace talus::verification::problems {

/// Checks two discs in a moving frame: e does not depend on the ratio of their masses, and the impact does not change
/// the velocity of their common centre of mass.
void check_masses(Findings& findings, const Setup& setup);

/// Checks that the rate of the overlap is the difference of the velocities (Eq. 20 with the minus sign), so that e is
/// the same in all frames.
void check_frames(Findings& findings, const Setup& setup);

/// Checks off-centre and pivoted impacts, with the damping from the effective mass at the contact point.
void check_levers(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
