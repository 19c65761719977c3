#include "solver/geometry/pose.hpp"

#include <sleef.h>

#include <cmath>

namespace talus {
namespace {

/// SLEEF's plain-C routine without fused operations: the same bits on every machine and instruction set (the C library
/// picks one of several by the processor), error at most one unit of the last place.
Rotation by_library(double angle) {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(angle);
  return {both.y, both.x};
}

}  // namespace

// The angle less the nearest whole number k of quarter turns (Cody & Waite 1980). A quarter turn is the sum of three
// numbers, the first two of 33 bits, so that their products with k are exact up to k = 2^20; what the difference rounds
// off is carried along to first order.
Rotation rotation_by_any_angle(double angle) {
  constexpr double most = 1e5;
  if (!(std::abs(angle) <= most)) return by_library(angle);
  constexpr double quarter_1 = 0x1.921fb544p+0, quarter_2 = 0x1.0b4611a6p-34, quarter_3 = 0x1.3198a2e037073p-69;
  constexpr double to_whole = 0x1.8p+52;  // added and taken off again it leaves the nearest whole number
  const double k = (angle * 0x1.45f306dc9c883p-1 + to_whole) - to_whole;
  const double first = angle - k * quarter_1;
  const double second = k * quarter_2;
  const double difference = first - second;
  const double lost = ((first - difference) - second) - k * quarter_3;
  const double rest = difference + lost;
  const double tail = (difference - rest) + lost;
  if (!within_series(rest)) return by_library(angle);
  const Rotation near = rotation_by_series(rest);
  const double cosine = near.cosine - tail * near.sine;
  const double sine = near.sine + tail * near.cosine;
  switch (static_cast<long>(k) & 3) {
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    case 3:
      return {sine, -cosine};
    default:
      return {cosine, sine};
  }
}

}  // namespace talus
