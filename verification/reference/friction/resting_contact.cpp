#include "verification/reference/friction/resting_contact.hpp"

#include <cmath>

namespace talus::verification::reference {
namespace {

/// r_a of the header.
double arm(const RollingDisc& disc) {
  return disc.radius - 0.5 * disc.mass * disc.gravity * std::cos(disc.angle) / disc.normal_stiffness;
}

/// q of the header.
double inertia_ratio(const RollingDisc& disc) { return disc.inertia / (disc.mass * arm(disc) * arm(disc)); }

}  // namespace

double stopping_time(const SlidingBlock& block) { return block.speed / (block.friction * block.gravity); }

double stopped_displacement(const SlidingBlock& block) {
  const double rigid = block.speed * block.speed / (2.0 * block.friction * block.gravity);
  const double sunk = block.mass * block.gravity / (2.0 * block.normal_stiffness);
  const double slope = block.half_height / block.half_width;
  return rigid + block.friction * sunk * (1.0 - block.normal_stiffness / block.shear_stiffness - slope * slope);
}

double rolled_displacement(const RollingDisc& disc, double t) {
  const double q = inertia_ratio(disc), drive = disc.gravity * std::sin(disc.angle);
  const double stretch = q * disc.mass * drive / (1.0 + q) / disc.shear_stiffness;
  return (0.5 * drive * t * t + q * stretch) / (1.0 + q);
}

double rolled_spin(const RollingDisc& disc, double t) {
  return disc.gravity * std::sin(disc.angle) * t / ((1.0 + inertia_ratio(disc)) * arm(disc));
}

}  // namespace talus::verification::reference
