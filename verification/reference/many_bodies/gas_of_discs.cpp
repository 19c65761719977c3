#include "verification/reference/many_bodies/gas_of_discs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace talus::verification::reference {
namespace {

using std::numbers::pi;

void check(const GasOfDiscs& gas) {
  const bool fits = gas.solid_fraction > 0.0 && gas.solid_fraction < 0.7 && gas.restitution > 0.0 &&
                    gas.restitution <= 1.0 && gas.diameter > 0.0 && gas.mass > 0.0;
  if (!fits) throw std::invalid_argument{"gas of discs: a number is out of its range"};
}

/// Symmetric tensor.
struct Tensor {
  double xx{}, xy{}, yy{};

  void add(double factor, double x, double y) { xx += factor * x * x, xy += factor * x * y, yy += factor * y * y; }
};

/// Moments <q^n H(q)> of a Gaussian q.
struct ClosingMoments {
  double second{}, third{};

  ClosingMoments(double mean, double deviation) {
    const double z = mean / deviation;
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * pi), above = 0.5 * std::erfc(-z / std::sqrt(2.0));
    const double square = deviation * deviation;
    second = (mean * mean + square) * above + mean * deviation * density;
    third = (mean * mean * mean + 3.0 * mean * square) * above + (mean * mean + 2.0 * square) * deviation * density;
  }
};

/// Collision terms, with lengths in d, times in 1/rate, masses in m.
struct Collisions {
  Tensor production;  ///< dK/dt
  Tensor stress;      ///< over n m
  double loss{};      ///< over n m
};

constexpr int directions = 256;

/// Unit vectors of evenly spread directions.
struct Directions {
  std::array<double, directions> x{}, y{};

  Directions() {
    constexpr double part = 2.0 * pi / directions;
    for (int i = 0; i < directions; ++i) {
      const auto k = static_cast<std::size_t>(i);
      x[k] = std::cos((i + 0.5) * part), y[k] = std::sin((i + 0.5) * part);
    }
  }
};

Collisions collide(const GasOfDiscs& gas, double n_chi, const Tensor& k) {
  static const Directions all;
  const double kept = 0.5 * (1.0 + gas.restitution), part = 2.0 * pi / directions;
  Collisions sum;
  for (std::size_t i = 0; i < directions; ++i) {
    const double x = all.x[i], y = all.y[i];
    const double along_x = k.xx * x + k.xy * y, along_y = k.xy * x + k.yy * y;
    const double variance = 2.0 * (along_x * x + along_y * y), mean = -x * y;
    const ClosingMoments closing{mean, std::sqrt(variance)};
    // <q^2 H c> = K.k (<q^3 H> - <q> <q^2 H>)/variance
    const double carried = (closing.third - mean * closing.second) / variance;
    sum.production.add(n_chi * part * kept * kept * closing.third, x, y);
    sum.production.xx -= n_chi * part * kept * carried * 2.0 * x * along_x;
    sum.production.xy -= n_chi * part * kept * carried * (x * along_y + y * along_x);
    sum.production.yy -= n_chi * part * kept * carried * 2.0 * y * along_y;
    sum.stress.add(0.5 * kept * n_chi * part * closing.second, x, y);
    sum.loss += (1.0 - gas.restitution * gas.restitution) / 8.0 * n_chi * part * closing.third;
  }
  return sum;
}

}  // namespace

double contact_density(double solid_fraction) {
  return (1.0 - 7.0 * solid_fraction / 16.0) / ((1.0 - solid_fraction) * (1.0 - solid_fraction));
}

double number_density(const GasOfDiscs& gas) {
  check(gas);
  return 4.0 * gas.solid_fraction / (pi * gas.diameter * gas.diameter);
}

double collision_rate(const GasOfDiscs& gas, double temperature) {
  return 2.0 * std::sqrt(pi * temperature / gas.mass) * number_density(gas) * gas.diameter *
         contact_density(gas.solid_fraction);
}

double cooling_rate(const GasOfDiscs& gas, double temperature) {
  return 0.25 * (1.0 - gas.restitution * gas.restitution) * collision_rate(gas, temperature);
}

double haff_temperature(const GasOfDiscs& gas, double first, double t) {
  const double slowed = 1.0 + cooling_rate(gas, first) * t;
  return first / (slowed * slowed);
}

double pressure(const GasOfDiscs& gas, double temperature) {
  return number_density(gas) * temperature *
         (1.0 + (1.0 + gas.restitution) * gas.solid_fraction * contact_density(gas.solid_fraction));
}

GasOfDiscs hardened(const GasOfDiscs& gas, double temperature, double stiffness) {
  check(gas);
  GasOfDiscs hard = gas;
  hard.diameter -= std::sqrt(pi * temperature / (2.0 * stiffness));
  hard.solid_fraction *= hard.diameter * hard.diameter / (gas.diameter * gas.diameter);
  return hard;
}

double elastic_viscosity(const GasOfDiscs& gas, double temperature) {
  check(gas);
  const double phi = gas.solid_fraction, chi = contact_density(phi);
  return std::sqrt(gas.mass * temperature / pi) / (2.0 * gas.diameter) *
         (1.0 / chi + 2.0 * phi + (1.0 + 8.0 / pi) * phi * phi * chi);
}

SteadyShear newtonian_shear(const GasOfDiscs& gas, double rate) {
  // Viscosity and cooling rate grow as sqrt(T): eta rate^2 = 2 n T/tau gives T.
  const double viscosity = elastic_viscosity(gas, 1.0), cooling = cooling_rate(gas, 1.0);
  SteadyShear steady;
  steady.temperature = viscosity * rate * rate / (2.0 * number_density(gas) * cooling);
  steady.shear = elastic_viscosity(gas, steady.temperature) * std::abs(rate);
  steady.pressure = pressure(gas, steady.temperature);
  steady.loss = steady.shear * std::abs(rate);
  return steady;
}

SteadyShear gaussian_shear(const GasOfDiscs& gas, double rate) {
  const GasOfDiscs unit{.solid_fraction = gas.solid_fraction, .restitution = gas.restitution};
  const double n_chi = number_density(unit) * contact_density(unit.solid_fraction);
  const double first = newtonian_shear(unit, 1.0).temperature;
  Tensor k{first, 0.0, first};
  Collisions collisions;
  for (int pass = 0;; ++pass) {
    if (pass == 1000000) throw std::runtime_error{"gaussian_shear: not steady after a million steps"};
    collisions = collide(unit, n_chi, k);
    const Tensor gain{collisions.production.xx - 2.0 * k.xy, collisions.production.xy - k.yy, collisions.production.yy};
    const double t = 0.5 * (k.xx + k.yy), step = 0.3 / (collision_rate(unit, t) + 1.0);
    k.xx += step * gain.xx, k.xy += step * gain.xy, k.yy += step * gain.yy;
    if (std::max({std::abs(gain.xx), std::abs(gain.xy), std::abs(gain.yy)}) < 1e-12 * t) break;
  }
  const double scale = gas.mass * gas.diameter * gas.diameter * rate * rate, n = number_density(gas);
  SteadyShear steady;
  steady.temperature = scale * 0.5 * (k.xx + k.yy);
  steady.shear = -n * scale * (k.xy + collisions.stress.xy);
  steady.pressure = n * scale * 0.5 * (k.xx + k.yy + collisions.stress.xx + collisions.stress.yy);
  steady.difference = n * scale * (k.xx - k.yy + collisions.stress.xx - collisions.stress.yy);
  steady.loss = n * scale * std::abs(rate) * collisions.loss;
  return steady;
}

}  // namespace talus::verification::reference
