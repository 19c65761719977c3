#include "solver/geometry/pose.hpp"

#include <sleef.h>

namespace talus {
namespace {

/// SLEEF's plain-C routine without fused operations: bit-identical on every machine and instruction set (the C library
/// selects a routine by processor); error at most one unit in the last place.
Rotation by_library(double angle) {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(angle);
  return {both.y, both.x};
}

}  // namespace

Rotation rotation_by_any_angle(double angle) {
  const Turned turned = rotation_by_quarter_turns(angle);
  return turned.found ? turned.rotation : by_library(angle);
}

}  // namespace talus
