#pragma once

#include <string>

namespace talus {

/// Steps of its own that a method with step control may take within one time step h; with more, the run has failed: it
/// would not end in a time that anybody waits for.
inline constexpr long most_internal_steps = 1'000'000;
/// The message then; t: the time that is reached [T].
[[nodiscard]] std::string internal_steps_failure(double t);

}  // namespace talus
