#pragma once

#include <span>
#include <vector>

#include "verification/reference/impacts/end_rule.hpp"

/// Exact motion, segment by segment, of a disc falling on a wall with a linear spring-dashpot contact.
///
/// x = overlap of disc and wall [L], > 0 while overlapping; the gap is -x. Gravity g >= 0 pulls into the wall.
///   touching:  x'' + 2 xi w0 x' + w0^2 x = g      (wall force over mass: w0^2 x + 2 xi w0 x' = g - x'')
///   free:      x'' = g
/// From (x_a, v_a) with y = x - g/w0^2, s = sqrt(|1 - xi^2|), u = w0 t, C = cos(s u), S = sin(s u)/s (cosh, sinh for
/// xi > 1; 1 and u at xi = 1):
///   y = exp(-xi u) [y_a C + (v_a/w0 + xi y_a) S],   x' = exp(-xi u) [v_a C - (xi v_a + w0 y_a) S].
/// Attractive: contact ends when x falls to 0; clamped: when the force falls to 0, with x > 0. Free flight ends when x
/// rises to 0 or, under the clamped rule while still overlapping, when the force of the law rises to 0 again. The first
/// extremum of x (of the force) in each segment is known in closed form; between extrema the function is monotone, so
/// its root is bracketed and found at 50 digits (TOMS 748). Everything is evaluated at 50 digits. With gravity the
/// bounces shrink until the disc stays in contact for ever, at x -> g/w0^2: the last segment has no end.
namespace talus::verification::reference {

struct DampedBounce {
  double frequency{};                ///< w0 [rad/T] > 0.
  double damping_ratio{};            ///< xi [-] >= 0.
  double gravity{};                  ///< g [L/T^2] >= 0.
  double gap{};                      ///< Distance to the wall at t = 0 [L] >= 0.
  double speed{};                    ///< x' at t = 0 [L/T], > 0 towards the wall.
  EndRule end{EndRule::attractive};  ///< When contact ends.
};

/// One contact.
struct Bounce {
  double start_time{};     ///< [T].
  double start_speed{};    ///< x' at the start [L/T].
  double end_time{};       ///< [T]; infinite when the disc stays.
  double end_velocity{};   ///< x' at the end [L/T], <= 0; 0 when the disc stays.
  double end_depth{};      ///< Overlap at the end [L]; g/w0^2 when the disc stays.
  double largest_depth{};  ///< Largest overlap [L].
  double apex_gap{};       ///< Largest gap of the flight that follows [L]; infinite without gravity, 0 when it stays.
};

/// The first `count` contacts, fewer when the disc stays in contact or flies away for ever. Throws
/// std::invalid_argument on parameters out of range (gap > 0 without gravity needs speed > 0).
[[nodiscard]] std::vector<Bounce> bounces(const DampedBounce& drop, int count);

struct BounceState {
  double gap{};       ///< -x [L].
  double velocity{};  ///< x' [L/T], > 0 towards the wall.
  bool touching{};    ///< The contact force acts.
};

/// States at the ascending times `times` >= 0 [T].
[[nodiscard]] std::vector<BounceState> bounce_states(const DampedBounce& drop, std::span<const double> times);

}  // namespace talus::verification::reference
