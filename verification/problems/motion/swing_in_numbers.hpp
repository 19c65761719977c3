#pragma once

#include <cstdint>

#include "verification/reference/stepped_swing.hpp"

/// The solver's integrators of fixed step on one body that swings, in numbers of 24, 53, 64 and 113 bits.
namespace talus::verification::problems {

/// Accelerations of the planted fault, at their coarsest.
enum class Forces { exact, in_double, in_float };

struct SwingRun {
  reference::Parts place{};     ///< x at the end, synchronised
  std::uint64_t evaluations{};  ///< of the force
};

/// The run of `swing` by the solver's integrator, in numbers of `bits` bits. Step and damping must be numbers of 24
/// bits, so that all run the same problem. Errors: std::invalid_argument for other bits.
[[nodiscard]] SwingRun swing_in_numbers(const reference::SteppedSwing& swing, int bits, Forces forces = Forces::exact);

}  // namespace talus::verification::problems
