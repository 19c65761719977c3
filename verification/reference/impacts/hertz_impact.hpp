#pragma once

#include "verification/reference/impacts/end_rule.hpp"

/// Central impact of round bodies by Hertz's law, with the dashpot that gives the same restitution at every speed.
///
///   m x'' = -k x^(3/2) - 2 xi sqrt(5/4 k m) x^(1/4) x',     x(0) = 0, x'(0) = v
///
/// k = 4/3 E sqrt(R) (Hertz 1882). With y = sqrt(4k/5m) x^(5/4), so that y^2/2 is the elastic energy over m, and the
/// angle u with du/dt = sqrt(5k/4m) x^(1/4), division of both sides by du/dt gives
///   dy/du = x',    dx'/du = -y - 2 xi x':
/// which is the linear spring and dashpot of restitution.hpp with w = 1 (Antypov & Elliott, EPL 94 (2011) 50004; Tsuji
/// et al. 1992 had the dashpot without its constant). x = 0 is y = 0 and F = 0 is y + 2 xi x' = 0, so e equals the
/// linear one for both end rules and every speed. The largest y is v exp(-xi A), and
///   x_max = (5 m y_max^2/(4 k))^(2/5),     T = integral of du/(du/dt) from touch to end.
/// Undamped, with s = x/x_max:  T = (2 x_max/v) int_0^1 ds/sqrt(1 - s^(5/2)) = (4/5) B(2/5, 1/2) x_max/v
///   = 2.943275... x_max/v.
namespace talus::verification::reference {

struct HertzImpact {
  double stiffness{};       ///< k [F/L^(3/2)] > 0
  double damping_ratio{};   ///< xi, 0 <= xi < 1
  double effective_mass{};  ///< m [M] > 0
  double approach_speed{};  ///< v [L/T] > 0
};

struct HertzEvents {
  double restitution{};    ///< e
  double contact_time{};   ///< T; at 50 digits if undamped, by quadrature to about 1e-13 if damped
  double largest_depth{};  ///< largest overlap x_max [L]
};

/// Events of the impact. std::invalid_argument outside the ranges above.
[[nodiscard]] HertzEvents hertz_events(const HertzImpact& impact, EndRule end);

/// T v/x_max of the undamped impact.
[[nodiscard]] double hertz_time_factor();

}  // namespace talus::verification::reference
