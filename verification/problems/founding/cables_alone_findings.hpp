#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// The particle of the case `two_cable` launched through its unstretched cables, the striker out of reach, by velocity
/// Verlet: orders, and the constants that follow from the Hamiltonian which the method keeps. Fault `euler_cromer`.
void check_cables_alone(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
