#pragma once

#include "verification/check/case.hpp"

/// What the case `restitution` finds about the mass that an impact meets.
namespace talus::verification::problems {

/// Two discs in a moving frame: e does not depend on the ratio of their masses, their common velocity not on the
/// impact.
void check_masses(Findings& findings, const Setup& setup);

/// The overlap's rate is the difference of the velocities (Eq. 20 with the minus sign): e is the same in all frames.
void check_frames(Findings& findings, const Setup& setup);

/// Off-centre and pivoted impacts: the damping comes from the effective mass at the contact point.
void check_levers(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
