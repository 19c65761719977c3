#include "solver/geometry/superquadric.hpp"

#include <sleef.h>

#include <algorithm>
#include <cmath>

#include "solver/geometry/pose.hpp"

namespace talus {
namespace {

/// base^exponent by squaring.
double whole_power(double base, int exponent) {
  double product = 1.0;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) product *= base;
    base *= base;
  }
  return product;
}

constexpr double largest_whole_exponent = 64.0;

}  // namespace

// SLEEF's plain-C routine, as for the sine; whole exponents, which most outlines have, by multiplication.
double power(double base, double exponent) {
  if (exponent >= 0.0 && exponent <= largest_whole_exponent) {
    const int whole = static_cast<int>(exponent);
    if (static_cast<double>(whole) == exponent) return whole_power(base, whole);
  }
  return Sleef_cinz_powd1_u10purec(base, exponent);
}

// The larger term is taken out before the power, so that neither a far point nor a high exponent overflows.
double gauge(const Superquadric& shape, Vec2 p) {
  const double u = std::abs(p.x) / shape.half_width;
  const double v = std::abs(p.y) / shape.half_height;
  const double most = std::max(u, v);
  if (most == 0.0) return 0.0;
  const double share = std::min(u, v) / most;
  return most * power(1.0 + power(share, shape.exponent), 1.0 / shape.exponent);
}

bool is_inside(const Superquadric& shape, Vec2 p) {
  const double u = std::abs(p.x) / shape.half_width;
  const double v = std::abs(p.y) / shape.half_height;
  if (u >= 1.0 || v >= 1.0) return false;
  return power(u, shape.exponent) + power(v, shape.exponent) < 1.0;
}

Vec2 boundary_point(const Superquadric& shape, double t) {
  const Rotation turned = rotation(t);
  const double c = power(std::abs(turned.cosine), 2.0 / shape.exponent);
  const double s = power(std::abs(turned.sine), 2.0 / shape.exponent);
  return {shape.half_width * std::copysign(c, turned.cosine), shape.half_height * std::copysign(s, turned.sine)};
}

}  // namespace talus
