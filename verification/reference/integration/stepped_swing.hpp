#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// The oscillator x'' = -x - c x', released at x = 1, integrated without rounding: one step of each method is a linear
/// map of a few numbers, whose powers are computed at 50 digits.
namespace talus::verification::reference {

/// Fixed-step methods, by their published equations.
enum class SwingMethod { euler_cromer, central_difference, lagged_central_difference, velocity_verlet, runge_kutta };

struct SteppedSwing {
  SwingMethod method{};
  double damping{};      ///< c [1/T]
  double step{};         ///< step [T]; exactly this number
  std::int64_t steps{};  ///< number of steps
};

/// A number as an exact sum of three doubles, largest first: sufficient for 113 bits.
using Parts = std::array<double, 3>;

/// x after the steps, at the time of the last (positions of staggered methods moved back by half a step), to the
/// nearest double.
[[nodiscard]] double unrounded_position(const SteppedSwing& swing);

/// Difference of each of `positions`, results of the same steps in some number type, from the unrounded result.
[[nodiscard]] std::vector<double> rounding_errors(const SteppedSwing& swing, const std::vector<Parts>& positions);

/// Difference of `position` from the exact undamped x = cos(n h): truncation and rounding error of the method. Throws
/// std::invalid_argument with damping.
[[nodiscard]] double whole_error(const SteppedSwing& swing, const Parts& position);

}  // namespace talus::verification::reference
