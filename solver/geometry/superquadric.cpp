#include "solver/geometry/superquadric.hpp"

#ifdef __SSE2__
#include <emmintrin.h>
#endif
#include <sleef.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// Whether the exponent is an integer from 0 to the largest; stores that integer.
bool is_whole(double exponent, int& whole) {
  if (!(exponent >= 0.0 && exponent <= largest_whole_exponent)) return false;
  whole = static_cast<int>(exponent);
  return static_cast<double>(whole) == exponent;
}

/// Two bases raised to the same exponent.
struct PowerPair {
  double first = 0.0;
  double second = 0.0;
};

#ifdef __SSE2__
/// SLEEF's SSE2 routine without fused operations, for two numbers: bit-identical to its plain-C routine. Two powers
/// take 0.3 to 0.4 of the time of plain C, and one power 0.6.
PowerPair fractional_power_pair(double first, double second, double exponent) {
  const __m128d both = Sleef_cinz_powd2_u10sse2(_mm_set_pd(second, first), _mm_set1_pd(exponent));
  return {_mm_cvtsd_f64(both), _mm_cvtsd_f64(_mm_unpackhi_pd(both, both))};
}
double fractional_power(double base, double exponent) { return fractional_power_pair(base, base, exponent).first; }
#else
double fractional_power(double base, double exponent) { return Sleef_cinz_powd1_u10purec(base, exponent); }
PowerPair fractional_power_pair(double first, double second, double exponent) {
  return {fractional_power(first, exponent), fractional_power(second, exponent)};
}
#endif

/// power() of two bases, faster than two separate calls.
PowerPair power_pair(double first, double second, double exponent) {
  if (int whole{}; is_whole(exponent, whole)) return {whole_power(first, whole), whole_power(second, whole)};
  return fractional_power_pair(first, second, exponent);
}

}  // namespace

// Uses SLEEF's routine, as for the sine; integer exponents, which most outlines have, by multiplication.
double power(double base, double exponent) {
  if (int whole{}; is_whole(exponent, whole)) return whole_power(base, whole);
  return fractional_power(base, exponent);
}

// The first guess y = e^(ln x/n) uses the leading terms of two series. With s = (x - r)/(x + r), r^2 = 2, the error of
//   ln x = ln r + 2 (s + s^3/3 + s^5/5 + ...),  |s| < 0.172,
// is less than 2 s^7/7 = 1.3e-6. This is also n times the relative error of the guess, apart from the exponential's
// z^6/720 < 2.1e-7 for n >= 3. Halley's step for y^n = x reduces a relative error e to (n^2 - 1)/12 e^3, here below
// 2e-19.
double root(double x, double degree) {
  constexpr double r = std::numbers::sqrt2, ln_r = 0.5 * std::numbers::ln2;
  if (x == 1.0) return 1.0;
  if (degree == 2.0) return std::sqrt(x);
  int n{};
  if (!is_whole(degree, n) || n < 3) return power(x, 1.0 / degree);
  const double s = (x - r) / (x + r), s2 = s * s;
  const double z = (ln_r + (2.0 * s + s * s2 * (2.0 / 3.0 + s2 * (2.0 / 5.0)))) / degree, z2 = z * z;
  const double y = (1.0 + z) + z2 * ((1.0 / 2.0 + z * (1.0 / 6.0)) + z2 * (1.0 / 24.0 + z * (1.0 / 120.0)));
  const double p = whole_power(y, n);
  return y + y * (2.0 * (x - p) / ((degree + 1.0) * p + (degree - 1.0) * x));
}

// The larger term is factored out before the power, so that neither a far point nor a high exponent overflows.
double gauge(const Superquadric& shape, Vec2 p) {
  const double u = std::abs(p.x) / shape.half_width;
  const double v = std::abs(p.y) / shape.half_height;
  const double maximum = std::max(u, v);
  if (maximum == 0.0) return 0.0;
  const double ratio = std::min(u, v) / maximum;
  return maximum * root(1.0 + power(ratio, shape.exponent), shape.exponent);
}

bool is_inside(const Superquadric& shape, Vec2 p) {
  const double u = std::abs(p.x) / shape.half_width;
  const double v = std::abs(p.y) / shape.half_height;
  if (u >= 1.0 || v >= 1.0) return false;
  const PowerPair raised = power_pair(u, v, shape.exponent);
  return raised.first + raised.second < 1.0;
}

namespace {

/// Gradient of (|x/a|^n + |y/b|^n)/n.
Vec2 gradient(const Superquadric& shape, Vec2 p) {
  const double u = std::abs(p.x) / shape.half_width, v = std::abs(p.y) / shape.half_height;
  const PowerPair raised = power_pair(u, v, shape.exponent - 1.0);
  return {std::copysign(raised.first / shape.half_width, p.x), std::copysign(raised.second / shape.half_height, p.y)};
}

}  // namespace

Vec2 outward_normal(const Superquadric& shape, Vec2 p) {
  const Vec2 g = gradient(shape, p);
  return (1.0 / norm(g)) * g;
}

// By Hoelder's inequality the support function is the dual norm h = (|a m_x|^q + |b m_y|^q)^(1/q), q = n/(n - 1),
// reached at x = a |a m_x/h|^(q - 1), y alike.
Vec2 farthest_point(const Superquadric& shape, Vec2 m) {
  const double q = shape.exponent / (shape.exponent - 1.0);
  const double h = gauge({1.0 / shape.half_width, 1.0 / shape.half_height, q}, m);
  const PowerPair raised =
      power_pair(shape.half_width * std::abs(m.x) / h, shape.half_height * std::abs(m.y) / h, q - 1.0);
  return {std::copysign(shape.half_width * raised.first, m.x), std::copysign(shape.half_height * raised.second, m.y)};
}

// Curvature of a line F = const: (F_xx F_y^2 + F_yy F_x^2)/|grad F|^3, because F_xy is zero here.
double curvature(const Superquadric& shape, Vec2 p) {
  const double n = shape.exponent, a = shape.half_width, b = shape.half_height;
  const Vec2 g = gradient(shape, p);
  const PowerPair raised = power_pair(std::abs(p.x) / a, std::abs(p.y) / b, n - 2.0);
  const double xx = (n - 1.0) * raised.first / (a * a);
  const double yy = (n - 1.0) * raised.second / (b * b);
  const double length = norm(g);
  return (xx * g.y * g.y + yy * g.x * g.x) / (length * length * length);
}

Vec2 boundary_point(const Superquadric& shape, double t) {
  const Rotation turned = rotation(t);
  const PowerPair raised = power_pair(std::abs(turned.cosine), std::abs(turned.sine), 2.0 / shape.exponent);
  return {shape.half_width * std::copysign(raised.first, turned.cosine),
          shape.half_height * std::copysign(raised.second, turned.sine)};
}

}  // namespace talus
