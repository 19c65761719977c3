#include "solver/geometry/pose.hpp"

#include <sleef.h>

namespace talus {

// SLEEF's plain-C routine without fused operations: the same bits on every machine and instruction set (the C library
// picks one of several by the processor), error at most one unit of the last place.
Rotation rotation_by_any_angle(double angle) {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(angle);
  return {both.y, both.x};
}

}  // namespace talus
