#pragma once

#include <array>

#include "verification/check/case.hpp"
#include "verification/reference/stepped_latch.hpp"

/// Restitution of two latching discs, K1/K2 = .49, against the step, by each of four methods.
namespace talus::verification::problems {

struct LatchScheme {
  const char* name;
  const char* label;
  reference::StepMap map;
};
inline constexpr std::array latch_schemes{LatchScheme{"euler", "Euler", reference::StepMap::euler},
                                          LatchScheme{"taylor", "Taylor", reference::StepMap::taylor},
                                          LatchScheme{"euler_cromer", "Euler-Cromer", reference::StepMap::leapfrog},
                                          LatchScheme{"velocity_verlet", "Verlet", reference::StepMap::leapfrog}};

/// Mean and deviation over the phases at 5 to 120 steps in a contact, where methods gain energy, and what phases do.
void check_latching_table(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
