#pragma once

#include <string>

namespace talus {

/// Maximum number of internal steps of step control within one time step h. A run that needs more has failed: it would
/// not end in an acceptable time.
inline constexpr long maximum_internal_steps = 1'000'000;
/// Message of that failure; t: the time reached [T].
[[nodiscard]] std::string internal_steps_failure(double t);

/// Message if no step, however short, satisfies the tolerance; t: the time reached [T].
[[nodiscard]] std::string short_step_failure(double tolerance, double t);

}  // namespace talus
