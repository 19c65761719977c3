#include "verification/reference/motion/constant_force.hpp"

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {

double position_at(const ConstantForce& flight, double t) {
  const Real50 time{t};
  return nearest(flight.position + time * flight.speed + time * time * flight.acceleration / 2);
}

double speed_at(const ConstantForce& flight, double t) {
  return nearest(flight.speed + Real50{t} * flight.acceleration);
}

double semi_implicit_euler_error(const ConstantForce& flight, double step, long steps) {
  return nearest(Real50{step} * step * steps * flight.acceleration / 2);
}

}  // namespace talus::verification::reference
