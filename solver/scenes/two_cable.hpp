#pragma once

#include "solver/laws/linear_spring_dashpot.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::scenes {

/// A particle between two cables, hit by another (Mustoe & Huttelmaier 1993, validation problem 1; its data are the
/// defaults, in SI). Both are circles that touch at t = 0; motion along x, no gravity.
///
///        anchor (0, l)
///          |
///   M ->  (m)     x ->
///          |
///        anchor (0, -l)
struct TwoCable {
  double cable_stiffness{4.0};  ///< k [F/L]
  double cable_length{10.0};    ///< l, unstretched [L]
  double mass{1.0};             ///< m [M]
  double striker_mass{2.0};     ///< M [M]
  double speed{2.0};            ///< v0 of the striker [L/T]
  double radius{0.5};  ///< of both circles [L]; the motion does not depend on it while the overlap stays below 2 r
  LinearSpringDashpot contact;  ///< law between them
};

/// Scene with bodies "particle" and "striker", contact "impact" and cables "upper" and "lower". The caller sets
/// integrator and plan. Errors: InputError as by ModelBuilder.
[[nodiscard]] Scene two_cable(const TwoCable& parameters);

}  // namespace talus::scenes
