#pragma once

namespace talus {

/// Mass and moment of inertia of a solid in plane motion; the inertia is about the axis along the fence through its
/// centre.
struct MassProperties {
  double mass{};     ///< [M]
  double inertia{};  ///< [M L^2]
};

/// Ellipsoid with semi-axes a, b in the plane and min(a, b) across it, and the given density [M/L^3]:
/// m = 4/3 pi a b min(a, b) rho, I = m (a^2 + b^2)/5. For a sphere this agrees with Mustoe & Huttelmaier 1993.
[[nodiscard]] MassProperties ellipsoid(double a, double b, double density);

/// Block with half-lengths a, b in the plane and a across it: m = 8 a^2 b rho, I = m (a^2 + b^2)/3, as printed for the
/// ground by Mustoe & Huttelmaier 1993.
[[nodiscard]] MassProperties block(double a, double b, double density);

/// Upright cylinder of radius a and height 2 b: m = 2 pi a^2 b rho, I = m (3 a^2 + 4 b^2)/12, the columns of
/// Mustoe & Huttelmaier 1993.
[[nodiscard]] MassProperties cylinder(double a, double b, double density);

}  // namespace talus
