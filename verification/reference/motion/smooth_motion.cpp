#include "verification/reference/motion/smooth_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace talus::verification::reference {
namespace {

/// Steps of the difference quotients, in units of time: their error is (w step)^2, plus rounding of 1e-19/step and
/// 1e-19/step^2.
constexpr Real first_quotient = 1e-6L, second_quotient = 2e-5L;

template <std::size_t n>
std::array<Real, n> sum(const std::array<Real, n>& a, Real factor, const std::array<Real, n>& b) {
  std::array<Real, n> out{};
  for (std::size_t i = 0; i < n; ++i)
    out[i] = a[i] + factor * b[i];
  return out;
}

/// The motion and its derivatives at one time.
struct Derivatives {
  SmoothState first, second, third;
};

Derivatives derivatives(const SmoothSystem& system, const SmoothState& x, Real t) {
  Derivatives found;
  found.first = rate(system, x, t);
  constexpr Real d = first_quotient, e = second_quotient;
  found.second =
      (0.5L / d) * (rate(system, x + d * found.first, t + d) + (-1.0L) * rate(system, x + (-d) * found.first, t - d));
  const SmoothState curve = (0.5L * e * e) * found.second;
  found.third = (1.0L / (e * e)) * (rate(system, x + e * found.first + curve, t + e) +
                                    rate(system, x + (-e) * found.first + curve, t - e) + (-2.0L) * found.first);
  return found;
}

/// Change of the accelerations for a change of the state.
Triple change(const SmoothSystem& system, const SmoothState& x, Real t, const SmoothState& along) {
  Real size = 1.0L;
  for (std::size_t i = 0; i < 3; ++i)
    size = std::max({size, std::abs(along.q[i]), std::abs(along.v[i])});
  const Real d = first_quotient / size;
  return sum(sum(Triple{}, 0.5L / d, system.acceleration(x + d * along, t)), -0.5L / d,
             system.acceleration(x + (-d) * along, t));
}

/// Change of the slip rate for a change of positions and velocities.
Memories slip_change(const SmoothSystem& system, const SmoothState& x, const Triple& q, const Triple& v) {
  constexpr Real d = first_quotient;
  const Memories up = system.slip(sum(x.q, d, q), x.v), down = system.slip(sum(x.q, -d, q), x.v);
  return sum(sum(system.slip(x.q, v), 0.5L / d, up), -0.5L / d, down);
}

struct Kind {
  Leapfrog method;
  int order;
  Real lag;
};

SmoothState error_rate(const SmoothSystem& system, const SmoothState& x, Real t, const SmoothState& e,
                       const Kind& kind) {
  SmoothState out{e.v, change(system, x, t, e), slip_change(system, x, e.q, e.v)};
  if (kind.order == 1) {
    if (system.damped) out.v = sum(out.v, -kind.lag, change(system, x, t, {{}, system.acceleration(x, t), {}}));
    if (kind.method == Leapfrog::late_slip) {
      const Triple none{};
      out.z = sum(out.z, 0.5L, slip_change(system, x, x.v, none));
    }
    return out;
  }
  const Derivatives d = derivatives(system, x, t);
  out.v = sum(out.v, -1.0L / 12.0L, d.third.v);
  const Triple none{};
  out.z = sum(out.z, 1.0L / 8.0L, slip_change(system, x, d.first.v, none));
  out.z = sum(out.z, 1.0L / 24.0L, system.slip(x.q, d.second.v));
  out.z = sum(out.z, -1.0L / 24.0L, d.third.z);
  return out;
}

/// Difference between the method's state and the curve on which its positions lie.
SmoothState above_curve(const SmoothSystem& system, const SmoothState& x, Real t, const Kind& kind) {
  SmoothState out;
  const Derivatives d = derivatives(system, x, t);
  if (kind.method == Leapfrog::euler_cromer) {
    out.v = sum(out.v, -0.5L, d.first.v);
  } else if (kind.order == 2 && kind.method == Leapfrog::velocity_verlet) {
    out.v = sum(out.v, 1.0L / 6.0L, d.second.v);
  } else if (kind.order == 2) {
    out.q = sum(out.q, 1.0L / 8.0L, d.first.v);
    out.v = sum(out.v, 1.0L / 24.0L, d.second.v);
    out.z = sum(out.z, 1.0L / 8.0L, system.slip(x.q, d.first.v));
  }
  return out;
}

/// A motion with its error, integrated together.
struct Pair {
  SmoothState x, e;
};

template <class Rate>
Pair advanced(const Pair& from, Real t, Real h, const Rate& rates) {
  const auto along = [&](Real fraction, const Pair& k) {
    return Pair{from.x + fraction * k.x, from.e + fraction * k.e};
  };
  const Pair k1 = rates(from, t), k2 = rates(along(0.5L * h, k1), t + 0.5L * h);
  const Pair k3 = rates(along(0.5L * h, k2), t + 0.5L * h), k4 = rates(along(h, k3), t + h);
  Pair out = along(h / 6.0L, k1);
  out = {out.x + (h / 3.0L) * k2.x + (h / 3.0L) * k3.x + (h / 6.0L) * k4.x,
         out.e + (h / 3.0L) * k2.e + (h / 3.0L) * k3.e + (h / 6.0L) * k4.e};
  return out;
}

template <class Rate>
Pair integrated(Pair from, Real end, long steps, const Rate& rates) {
  const Real h = end / static_cast<Real>(steps);
  for (long n = 0; n < steps; ++n)
    from = advanced(from, h * static_cast<Real>(n), h, rates);
  return from;
}

}  // namespace

SmoothState operator+(const SmoothState& a, const SmoothState& b) {
  return {sum(a.q, 1.0L, b.q), sum(a.v, 1.0L, b.v), sum(a.z, 1.0L, b.z)};
}

SmoothState operator*(Real factor, const SmoothState& a) {
  return {sum(Triple{}, factor, a.q), sum(Triple{}, factor, a.v), sum(Memories{}, factor, a.z)};
}

SmoothState rate(const SmoothSystem& system, const SmoothState& x, Real t) {
  return {x.v, system.acceleration(x, t), system.slip(x.q, x.v)};
}

SmoothState moved(const SmoothSystem& system, const SmoothState& start, Real end, long steps) {
  return integrated({start, {}}, end, steps, [&](const Pair& p, Real t) { return Pair{rate(system, p.x, t), {}}; }).x;
}

int order(Leapfrog method, const SmoothSystem& system) {
  return system.damped || method == Leapfrog::euler_cromer || method == Leapfrog::late_slip ? 1 : 2;
}

SmoothState leading_error(const SmoothSystem& system, const SmoothState& start, Real end, Leapfrog method, long steps) {
  const Kind kind{method, order(method, system), method == Leapfrog::lagged_central_difference ? 1.5L : 0.5L};
  const SmoothState first = (-1.0L) * above_curve(system, start, 0.0L, kind);
  const Pair last = integrated({start, first}, end, steps, [&](const Pair& p, Real t) {
    return Pair{rate(system, p.x, t), error_rate(system, p.x, t, p.e, kind)};
  });
  return last.e + above_curve(system, last.x, end, kind);
}

}  // namespace talus::verification::reference
