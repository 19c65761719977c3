#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// Checks systems whose contacts and cables neither open nor close: their highest frequency from the solver's forces,
/// against closed forms where these exist, and its growth under velocity Verlet on both sides of w h = 2. The fence is
/// held in equilibrium at states of its impact. Faults `kt_ignored`: the step of a disc that sticks follows from its
/// normal contact alone; `fence_by_rule`: that of the fence from the frequency of the 1993 rule.
void check_bilateral_systems(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
