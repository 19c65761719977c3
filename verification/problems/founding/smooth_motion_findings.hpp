#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// The smooth motions after the impacts of cases 1 and 2: each method's declared order. Fault
/// `euler_cromer_for_verlet`.
void check_smooth(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
