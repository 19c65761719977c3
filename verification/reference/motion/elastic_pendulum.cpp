#include "verification/reference/motion/elastic_pendulum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"
#include "verification/reference/mathematics/jacobi.hpp"
#include "verification/reference/mathematics/trajectory.hpp"
#include "verification/reference/motion/pendulum.hpp"

namespace talus::verification::reference {
namespace {

// Coordinates: angle, its rate, elongation d, its rate. Polar, so that the elongation of a stiff spring keeps its
// digits:
//   d'' = r th'^2 + g cos th - (k/m) d,   r th'' = -g sin th - 2 d' th'.
enum Coordinate : std::size_t { angle, angle_rate, stretch, stretch_rate };

Trajectory release(const ElasticPendulum& p) {
  if (!(p.mass > 0.0 && p.length > 0.0 && p.gravity > 0.0 && p.stiffness > 0.0 && p.amplitude > 0.0 &&
        p.amplitude < std::numbers::pi / 2.0)) {
    throw std::invalid_argument("ElasticPendulum: m, L, g, k must be > 0 and 0 < amplitude < pi/2");
  }
  const long double l = p.length;
  const long double g = p.gravity;
  const long double square = static_cast<long double>(p.stiffness) / p.mass;
  const auto rates = [l, g, square](const Coordinates& y, Coordinates& dydt) {
    const long double r = l + y[stretch];
    dydt[angle] = y[angle_rate];
    dydt[angle_rate] = (-g * std::sin(y[angle]) - 2.0L * y[stretch_rate] * y[angle_rate]) / r;
    dydt[stretch] = y[stretch_rate];
    dydt[stretch_rate] = r * y[angle_rate] * y[angle_rate] + g * std::cos(y[angle]) - square * y[stretch];
  };
  const long double amplitude = p.amplitude;
  const long double step = 0.1L / std::max(std::sqrt(square), std::sqrt(g / l));
  return {rates, {amplitude, 0.0L, g * std::cos(amplitude) / square, 0.0L}, 0.0L, step};
}

}  // namespace

double softness(const ElasticPendulum& p) { return p.mass * p.gravity / (p.stiffness * p.length); }

std::vector<ElasticPendulumState> elastic_pendulum_states(const ElasticPendulum& p, std::span<const double> times) {
  Trajectory path = release(p);
  std::vector<ElasticPendulumState> states;
  for (const double t : times) {
    path.advance_to(t);
    const Coordinates& y = path.coordinates();
    const long double sine = std::sin(y[angle]);
    const long double cosine = std::cos(y[angle]);
    const long double r = static_cast<long double>(p.length) + y[stretch];
    const long double across = r * y[angle_rate];
    const long double along = y[stretch_rate];
    states.push_back({static_cast<double>(r * sine), static_cast<double>(-r * cosine),
                      static_cast<double>(across * cosine + along * sine),
                      static_cast<double>(across * sine - along * cosine)});
  }
  return states;
}

double elastic_pendulum_period(const ElasticPendulum& p) {
  Trajectory path = release(p);
  const std::array<Guard, 1> right{[](const Coordinates& y) { return y[angle]; }};
  const std::array<Guard, 1> left{[](const Coordinates& y) { return -y[angle]; }};
  const auto patience = static_cast<long double>(100.0 * rigid_period(p) * (1.0 + softness(p)));
  const bool first = path.advance_until(right, patience).has_value();
  const long double start = path.time();
  const bool second = first && path.advance_until(left, patience).has_value();
  if (!second || !path.advance_until(right, patience)) throw std::runtime_error("elastic_pendulum_period: no swing");
  return static_cast<double>(path.time() - start);
}

double rigid_period(const ElasticPendulum& p) {
  return PendulumMotion::from_rest(std::sqrt(p.gravity / p.length), p.amplitude).period();
}

double period_softening(double amplitude) {
  if (!(amplitude > 0.0 && amplitude < std::numbers::pi)) {
    throw std::invalid_argument("period_softening: needs 0 < amplitude < pi");
  }
  // dK/dq = (E - q' K)/(2 q q'), dE/dq = (E - K)/(2 q), q' = 1 - q; 50 digits preserve the differences down to
  // A = 1e-8.
  const Real50 k = sin(Real50(amplitude) / 2);
  const Real50 q = k * k;
  const Real50 rest = cos(Real50(amplitude) / 2) * cos(Real50(amplitude) / 2);
  const auto [first, second] = ArithmeticGeometricMean<Real50>({k, Real50(cos(Real50(amplitude) / 2))}).complete();
  const Real50 first_slope = (second - rest * first) / (2 * q * rest);
  const Real50 second_slope = (second - first) / (2 * q);
  const Real50 slope = 4 * (first * (32 * q - 28) + first_slope * (16 * q * q - 28 * q + 13) + 24 * second +
                            second_slope * (24 * q - 12));
  const Real50 cosine = 1 - 2 * q;
  return nearest((slope - 4 * cosine * cosine * first_slope) / (16 * first));
}

}  // namespace talus::verification::reference
