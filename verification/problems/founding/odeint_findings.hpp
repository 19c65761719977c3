#pragma once

#include "verification/check/case.hpp"

namespace talus::verification::problems {

/// The pendulum's reference against Boost.Math's elliptic integrals and functions and against itself at 50 digits.
void check_references(Findings& findings);

/// odeint by itself, without any of the solver: what its step control keeps of a tolerance.
void check_odeint(Findings& findings);

/// The same steppers inside the solver and alone: two roads to one number.
void check_adapter(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
