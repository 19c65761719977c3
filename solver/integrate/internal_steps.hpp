#pragma once

#include <string>

namespace talus {

/// Most steps that step control may take within one time step h. With more the run has failed: it would not end in a
/// time that anybody waits for.
inline constexpr long most_internal_steps = 1'000'000;
/// The message then; t: the time that is reached [T].
[[nodiscard]] std::string internal_steps_failure(double t);

/// The message where no step, however short, is within the tolerance; t: the time that is reached [T].
[[nodiscard]] std::string short_step_failure(double tolerance, double t);

}  // namespace talus
