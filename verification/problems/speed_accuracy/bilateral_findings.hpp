#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// Systems whose contacts and cables stay as they are: what their fastest vibration is by the solver's forces, by
/// closed forms where there are any, and how velocity Verlet carries it on both sides of w h = 2. A fence is held where
/// its impact has brought it. Faults `kt_ignored`: the step of a disc that sticks is chosen by its normal contact
/// alone; `fence_by_rule`: that of the fence by the frequency of the 1993 rule.
void check_bilateral_systems(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
