#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// Signs of Eqs. 5-10: forces and moments of cables and contact on column and rock, from the accelerations of a run,
/// against the equations as printed and as corrected. Faults `contact_on_one_body_left_out`, `joint_below`.
void check_resultants(Findings& findings, const Setup& setup);

/// Eqs. 12 and 14 have one stiffness: the fence hangs at rest with the tensions of the static shape. Fault
/// `two_stiffnesses`.
void check_initial_tension(Findings& findings, const Setup& setup);

/// Section 3.1: which central columns are doubled. Fault `central_column_doubled`.
void check_doubling(Findings& findings, const Setup& setup);

/// Eq. 18's missing sign, Eq. 25's bound, and what the texts and decks of the report say of the same numbers.
void check_texts(Findings& findings);

}  // namespace talus::verification::problems
