#pragma once

#include <span>
#include <vector>

#include "verification/reference/cables/two_cable.hpp"
#include "verification/reference/impacts/end_rule.hpp"

/// Validation problem 1 with a soft contact: the particle on its cables is struck through a spring and a dashpot.
///
/// With the overlap d (striker's advance over the particle's, 0 at touch), k_n, c, and F = k_n d + c d' while in
/// contact:
///   m x'' = F - 2 T(x) x/sqrt(l^2 + x^2),   d'' = V' - x'',   M V' = -F;   d(0) = 0, d'(0) = v0, x(0) = x'(0) = 0.
/// The cables act during the contact, so Eq. 26 is only its limit for k_n -> infinity. The contact ends by the given
/// rule; afterwards the striker flies freely and the particle moves on its cables to its turning point. The overlap is
/// a separate coordinate, so that no digits are lost for a stiff contact. Integrated by `Trajectory` with located
/// events. A second contact is reported, but not simulated.
namespace talus::verification::reference {

struct SoftContact {
  double stiffness{};                ///< k_n [F/L] > 0.
  double damping{};                  ///< c [M/T] >= 0.
  EndRule end{EndRule::attractive};  ///< When the contact ends.
};

/// Both bodies at a time after the touch.
struct TwoCableState {
  double t{};                  ///< [T].
  double particle_position{};  ///< x [L].
  double particle_velocity{};  ///< v [L/T].
  double striker_velocity{};   ///< V [L/T].
  double contact_force{};      ///< F [F], on the particle along +x; 0 after the end.
};

struct TwoCableContact {
  TwoCableState at_end;                ///< When the contact ends.
  double depth_at_end{};               ///< Overlap [L]; 0 for the attractive rule.
  double largest_depth{};              ///< Largest overlap [L].
  double peak_force{};                 ///< Largest contact force [F].
  double peak_speed{};                 ///< Largest v [L/T], during the contact (the force then balances the cables).
  double turning_time{};               ///< From touch to v = 0 [T].
  double turning_distance{};           ///< x at that time [L].
  double turning_angle{};              ///< theta at that time [rad].
  bool struck_again{};                 ///< The striker touches the particle again before the turning point.
  std::vector<TwoCableState> samples;  ///< At the requested times.
};

/// Simulates the soft impact; `sample_times` ascending, >= 0 [T]. Throws std::invalid_argument on parameters out of
/// range and std::runtime_error if the contact does not end within twenty of its undamped half periods (an overdamped
/// attractive contact).
[[nodiscard]] TwoCableContact soft_impact(const TwoCable& problem, const SoftContact& contact,
                                          std::span<const double> sample_times = {});

}  // namespace talus::verification::reference
