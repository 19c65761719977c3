#include "solver/geometry/mass_properties.hpp"

#include <algorithm>
#include <numbers>

namespace talus {

MassProperties ellipsoid(double a, double b, double density) {
  const double mass = 4.0 / 3.0 * std::numbers::pi * a * b * std::min(a, b) * density;
  return {mass, 0.2 * mass * (a * a + b * b)};
}

MassProperties block(double a, double b, double density) {
  const double mass = 8.0 * a * a * b * density;
  return {mass, mass * (a * a + b * b) / 3.0};
}

MassProperties cylinder(double a, double b, double density) {
  const double mass = 2.0 * std::numbers::pi * a * a * b * density;
  return {mass, mass * (3.0 * a * a + 4.0 * b * b) / 12.0};
}

}  // namespace talus
