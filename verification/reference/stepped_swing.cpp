#include "verification/reference/rounded_swing.hpp"

#include <cmath>

#include "verification/reference/high_precision.hpp"

namespace talus::verification::reference {
namespace {

using Quadruple = boost::multiprecision::cpp_bin_float_quad;

struct Complex {
  Real50 re, im;
};

Complex operator*(const Complex& a, const Complex& b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }

Complex whole_power(Complex base, std::int64_t exponent) {
  Complex product{1, 0};
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) product = product * base;
    base = base * base;
  }
  return product;
}

/// x + i v of a rotation by one step; leapfrog's is a rotation of x alone.
Real50 unrounded(SwingMethod method, double step, std::int64_t steps) {
  const Real50 h{step};
  if (method == SwingMethod::verlet) {
    const Real50 cosine = 1 - h * h / 2;
    return whole_power({cosine, sqrt(1 - cosine * cosine)}, steps).re;
  }
  const Real50 h2 = h * h;
  return whole_power({1 - h2 / 2 + h2 * h2 / 24, h - h * h2 / 6}, steps).re;
}

template <class Real>
Real stepped_verlet(Real h, std::int64_t steps) {
  Real x{1}, v{0}, a{-1};
  const Real half = h / 2;
  for (std::int64_t i = 0; i < steps; ++i) {
    v += half * a;
    x += h * v;
    a = -x;
    v += half * a;
  }
  return x;
}

template <class Real>
Real stepped_runge_kutta(Real h, std::int64_t steps) {
  Real x{1}, v{0};
  const Real half = h / 2, sixth = h / 6;
  for (std::int64_t i = 0; i < steps; ++i) {
    const Real v1 = v, a1 = -x;
    const Real v2 = v + half * a1, a2 = -(x + half * v1);
    const Real v3 = v + half * a2, a3 = -(x + half * v2);
    const Real v4 = v + h * a3, a4 = -(x + h * v3);
    x += sixth * (v1 + 2 * (v2 + v3) + v4);
    v += sixth * (a1 + 2 * (a2 + a3) + a4);
  }
  return x;
}

template <class Real>
double error_in(SwingMethod method, double step, std::int64_t steps) {
  const Real x = method == SwingMethod::verlet ? stepped_verlet<Real>(Real{step}, steps)
                                               : stepped_runge_kutta<Real>(Real{step}, steps);
  return nearest(Real50{x} - unrounded(method, step, steps));
}

}  // namespace

double unit_round_off(Scalar scalar) {
  return std::ldexp(1.0, scalar == Scalar::bits_53 ? -53 : scalar == Scalar::bits_64 ? -64 : -113);
}

double unrounded_place(SwingMethod method, double step, std::int64_t steps) {
  return nearest(unrounded(method, step, steps));
}

double rounding_error(SwingMethod method, Scalar scalar, double step, std::int64_t steps) {
  switch (scalar) {
    case Scalar::bits_53:
      return error_in<double>(method, step, steps);
    case Scalar::bits_64:
      return error_in<long double>(method, step, steps);
    default:
      return error_in<Quadruple>(method, step, steps);
  }
}

double method_error(SwingMethod method, double step, std::int64_t steps) {
  return nearest(unrounded(method, step, steps) - cos(Real50{step} * steps));
}

}  // namespace talus::verification::reference
