#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// The oscillator x'' = -x - c x', let go at x = 1, by steps of a method without rounding: each method's step is one
/// linear map of a few numbers, and its powers are taken at 50 digits.
namespace talus::verification::reference {

/// The methods of fixed step, by their published equations.
enum class SwingMethod { euler_cromer, central_difference, lagged_central_difference, velocity_verlet, runge_kutta };

struct SteppedSwing {
  SwingMethod method{};
  double damping{};      ///< c [1/T]
  double step{};         ///< [T]; exactly this number
  std::int64_t steps{};  ///< how many
};

/// A number as an exact sum of three doubles, largest first: room for 113 bits.
using Parts = std::array<double, 3>;

/// x after the steps, at the time of the last (staggered methods taken back by half a step), to the nearest double.
[[nodiscard]] double unrounded_place(const SteppedSwing& swing);

/// How far each of `places`, results of the same steps in some numbers, is from that.
[[nodiscard]] std::vector<double> rounding_errors(const SteppedSwing& swing, const std::vector<Parts>& places);

/// How far `place` is from the oscillator's own x = cos(n h), where nothing damps: the method's error and its rounding.
/// Errors: std::invalid_argument with damping.
[[nodiscard]] double whole_error(const SteppedSwing& swing, const Parts& place);

}  // namespace talus::verification::reference
