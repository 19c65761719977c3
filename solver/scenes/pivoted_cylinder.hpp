#pragma once

#include "solver/model/contact.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::scenes {

/// A column that is pinned at its top, hit by a rock at the height of its centre of mass (Mustoe & Huttelmaier 1993,
/// validation problem 2; its data are the defaults, in slug, ft, s, with the radius 1.25 ft that the printed inertia
/// needs).
///
///        o pin (0, l/2)
///        |
///  M -> [ ]  centre of mass at the origin       x ->
///        |
struct PivotedCylinder {
  double mass{14.92};       ///< m of the column [M]
  double length{8.0};       ///< l [L]
  double inertia{85.42};    ///< I_G of the column [M L^2]
  double half_width{1.25};  ///< r of the column [L]
  double rock_mass{37.23};  ///< M [M]
  double rock_radius{1.2};  ///< of the rock: (3 M/(4 pi rho))^(1/3) at 165 lb/ft^3 [L]
  double speed{5.0};        ///< v0 of the rock, towards +x [L/T]
  double gravity{exact::standard_gravity / exact::foot_in_m};  ///< g, downwards [L/T^2]; 0: impact only
  ContactLaw contact;                                          ///< law between rock and column
  ContactMethod method{ContactMethod::resultant};
  int nodes{12};  ///< of the rock when method is `nodes`
};

/// Scene with bodies "column" (pinned; angle 0 when upright) and "rock" (free, I = 2/5 M R^2) and contact "impact". The
/// caller sets integrator and plan. Errors: InputError as by ModelBuilder.
[[nodiscard]] Scene pivoted_cylinder(const PivotedCylinder& parameters);

}  // namespace talus::scenes
