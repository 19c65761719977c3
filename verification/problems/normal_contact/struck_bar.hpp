#pragma once

#include "solver/laws/linear_spring_dashpot.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::verification::problems {

/// An upright bar at rest, struck on its side by a disc away from its centre of mass, without friction or gravity.
///
///        o   pin of a pinned bar (0, b)           y
///       +-+                                       |
///       | |  <- disc from -x at height `height`   +-- x,  origin at the bar's centre of mass
///       +-+
struct StruckBar {
  bool pinned{false};     ///< at the middle of its top; free otherwise
  double height{};        ///< of the disc's line of flight above the bar's centre [L]
  double mass{3.0};       ///< of the bar [M]
  double half_width{.5};  ///< a [L]
  double half_height{4};  ///< b [L]
  double disc_mass{2.0};  ///< [M]
  double speed{1.0};      ///< of the disc [L/T]
  double gap{};           ///< between disc and bar at t = 0 [L]
  LinearSpringDashpot law{};
};

/// Inertia of the bar about its centre of mass, m (a^2 + b^2)/3 [M L^2].
[[nodiscard]] double inertia(const StruckBar& bar);

/// Distance of the line of impact from the pin or, of a free bar, from the centre of mass [L].
[[nodiscard]] double arm(const StruckBar& bar);

/// Bodies "bar" and "disc" (a particle of radius 1), contact "impact". Integrator and plan are left to the caller.
[[nodiscard]] Scene struck_bar(const StruckBar& bar);

}  // namespace talus::verification::problems
