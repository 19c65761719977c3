#pragma once

#include "verification/check/case.hpp"

/// What the case `fidelity_ladder` finds about a contact of ever more nodes.
namespace talus::verification::problems {

/// The rock against a free column: formula, one resultant, 12 to 192 nodes, against the bed of springs. Fault
/// `stiffness_per_node`.
void check_contact_ladder(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
