#pragma once

#include <vector>

#include "verification/reference/impacts/restitution.hpp"

/// Oblique impact of a body on a plane: a linear spring and dashpot along the normal, friction by a spring and a slider
/// in series along the plane.
///
/// Along the normal the impact is that of restitution.hpp: N = k d + c d', until N falls to zero (an attractive contact
/// has no friction while it pulls). Along the plane, with slip rate v, stretch s and mobility n as in
/// dragged_slider.hpp,
///   stick   s' = v,                v' = -n k_s s/m      while k_s |s| < mu N
///   slip    s = +-mu N/k_s,        v' = -+n mu N/m      while slip continues in that direction: +-v > mu N'/k_s
/// Both are solved in closed form (during slip v changes by n mu times the change of the normal speed); the ends of the
/// phases are bracketed on a fine grid and bisected to round-off.
namespace talus::verification::reference {

struct ObliqueImpact {
  Impact normal;                  ///< k, c, m and the approach speed v_n
  double tangential_stiffness{};  ///< k_s [F/L] > 0
  double friction{};              ///< mu >= 0
  double mobility{1.0};           ///< n >= 1: 1 for a particle, 1 + m r^2/I for a disc
  double slip_rate{};             ///< v at touch [L/T]
};

struct ObliqueRebound {
  double slip_rate{};   ///< v afterwards [L/T]
  double speed_lost{};  ///< friction impulse over mass: tangential speed loss of the centre [L/T]
  double separation{};  ///< speed away from the plane afterwards [L/T]
  double dissipated{};  ///< work of the slider [F L]
  struct Phase {
    double begin{};      ///< after touch [T]
    int slips{};         ///< 0: sticks; +1, -1: direction of slip
    double slip_rate{};  ///< [L/T]
    double stretch{};    ///< [L]
  };
  std::vector<Phase> phases;
};

/// Rebound; std::invalid_argument for a damping ratio >= 1 or a problem outside the ranges above.
[[nodiscard]] ObliqueRebound rebound(const ObliqueImpact& impact, EndRule end);

/// Rigid impact with friction that slips throughout: the centre loses mu (1 + e) v_n along the plane.
[[nodiscard]] double speed_lost_by_gross_sliding(double friction, double restitution, double approach_speed);

/// Undamped: the largest ratio v/v_n without slip, mu k/k_s, if n k_s = k: the normal and tangential oscillations are
/// then in phase, and the slip rate is reversed.
[[nodiscard]] double full_stick_ratio(const ObliqueImpact& impact);

}  // namespace talus::verification::reference
