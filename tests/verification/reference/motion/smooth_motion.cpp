#include "verification/reference/motion/smooth_motion.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(smooth_motion_tests)

namespace ref = talus::verification::reference;
using ref::Leapfrog, ref::Memories, ref::Real, ref::SmoothState, ref::SmoothSystem, ref::Triple;

namespace {

/// A system that depends on time, in which only the slip is linear, in the velocity.
SmoothSystem wild(Real damping) {
  SmoothSystem system;
  system.damped = damping != 0.0L;
  system.acceleration = [=](const SmoothState& x, Real t) {
    return Triple{-4.0L * std::sin(x.q[0]) + x.q[1] * x.q[2] - x.z[0] - damping * x.v[0] * (1.0L + x.q[1] * x.q[1]),
                  -3.0L * x.q[1] + std::cos(1.3L * t) + x.z[0] * x.q[0] - damping * x.v[2],
                  -2.0L * x.q[2] + x.q[0] * x.q[0] - 0.5L * x.z[1]};
  };
  system.slip = [](const Triple& q, const Triple& v) {
    return Memories{(1.0L + q[1]) * v[0] - q[0] * v[2], q[2] * q[2] * v[1]};
  };
  return system;
}

constexpr SmoothState wild_start{{0.3L, -0.2L, 0.5L}, {0.4L, 0.1L, -0.6L}, {0.1L, -0.1L}};

void drift(const SmoothSystem& system, SmoothState& x, Real h, bool late = false) {
  Triple middle = x.q;
  for (std::size_t i = 0; i < 3; ++i)
    middle[i] += 0.5L * h * x.v[i], x.q[i] += h * x.v[i];
  const Memories slip = system.slip(late ? x.q : middle, x.v);
  for (std::size_t i = 0; i < 2; ++i)
    x.z[i] += h * slip[i];
}

void kick(SmoothState& x, const Triple& a, Real h) {
  for (std::size_t i = 0; i < 3; ++i)
    x.v[i] += h * a[i];
}

/// The methods, written out explicitly.
SmoothState stepped(const SmoothSystem& system, SmoothState x, Real end, long steps, Leapfrog method) {
  const Real h = end / static_cast<Real>(steps);
  const auto a = [&](const Triple& v, Real t) { return system.acceleration({x.q, v, x.z}, t); };
  const bool staggered = method == Leapfrog::central_difference || method == Leapfrog::lagged_central_difference;
  if (staggered) drift(system, x, 0.5L * h);
  Triple before = x.v, now = a(x.v, 0.0L);
  for (long n = 0; n < steps; ++n) {
    const Real t = h * static_cast<Real>(n);
    if (method == Leapfrog::velocity_verlet || method == Leapfrog::late_slip) {
      kick(x, now, 0.5L * h);
      drift(system, x, h, method == Leapfrog::late_slip);
      now = a(x.v, t + h);
      kick(x, now, 0.5L * h);
    } else {
      const Triple seen = method == Leapfrog::lagged_central_difference ? before : x.v;
      before = x.v;
      kick(x, a(seen, staggered ? t + 0.5L * h : t), h);
      drift(system, x, h);
    }
  }
  if (staggered) drift(system, x, -0.5L * h);
  return x;
}

/// Largest difference between the error of the written-out method, extrapolated to a step of zero, and the leading
/// error, relative to the largest component of the latter.
Real difference(const SmoothSystem& system, Leapfrog method) {
  constexpr Real end = 2.5L;
  const SmoothState exact = ref::moved(system, wild_start, end, 4000);
  const SmoothState leading = ref::leading_error(system, wild_start, end, method, 400);
  const int p = ref::order(method, system);
  const auto error = [&](long steps) {
    const Real h = end / static_cast<Real>(steps);
    return (1.0L / std::pow(h, p)) * (stepped(system, wild_start, end, steps, method) + (-1.0L) * exact);
  };
  // Eliminates the next power, h or h^2.
  const Real weight = p == 1 ? 2.0L : 4.0L / 3.0L;
  const SmoothState found = weight * error(8000) + (1.0L - weight) * error(4000);
  const SmoothState off = found + (-1.0L) * leading;
  Real largest = 0.0L, scale = 0.0L;
  for (std::size_t i = 0; i < 3; ++i) {
    largest = std::max({largest, std::abs(off.q[i]), std::abs(off.v[i])});
    scale = std::max({scale, std::abs(leading.q[i]), std::abs(leading.v[i])});
  }
  for (std::size_t i = 0; i < 2; ++i)
    largest = std::max(largest, std::abs(off.z[i]));
  return largest / scale;
}

}  // namespace

BOOST_AUTO_TEST_CASE(swing_of_the_leapfrog_in_closed_form) {
  SmoothSystem system;
  system.acceleration = [](const SmoothState& x, Real) { return Triple{-9.0L * x.q[0], 0.0L, 0.0L}; };
  system.slip = [](const Triple&, const Triple&) { return Memories{}; };
  const SmoothState start{{1.0L, 0.0L, 0.0L}, {}, {}};
  const SmoothState e = ref::leading_error(system, start, 2.0L, Leapfrog::velocity_verlet, 1000);
  // x_n = cos(w' t), v_n = -w sqrt(1 - (w h/2)^2) sin(w' t), w' = w (1 + (w h)^2/24)
  BOOST_TEST(std::abs(e.q[0] + 27.0L / 24.0L * 2.0L * std::sin(6.0L)) < 1e-6L);
  BOOST_TEST(std::abs(e.v[0] - (27.0L / 8.0L * std::sin(6.0L) - 81.0L / 24.0L * 2.0L * std::cos(6.0L))) < 1e-5L);
}

BOOST_AUTO_TEST_CASE(leading_error_is_what_the_methods_make) {
  for (const Leapfrog method : {Leapfrog::velocity_verlet, Leapfrog::central_difference,
                                Leapfrog::lagged_central_difference, Leapfrog::euler_cromer, Leapfrog::late_slip}) {
    for (const Real damping : {0.0L, 0.3L})
      BOOST_TEST(difference(wild(damping), method) < 2e-5L);  // the power after next of h = 3e-4, times 100
  }
}

BOOST_AUTO_TEST_SUITE_END()
