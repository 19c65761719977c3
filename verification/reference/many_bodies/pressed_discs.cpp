#include "verification/reference/many_bodies/pressed_discs.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace talus::verification::reference {

std::vector<double> column_overlaps(int discs, double mass, double gravity, double stiffness) {
  std::vector<double> overlaps;
  for (int carried = discs; carried > 0; --carried)
    overlaps.push_back(carried * mass * gravity / stiffness);
  return overlaps;
}

double column_frequency(int discs, double mass, double stiffness) {
  return 2.0 * std::sqrt(stiffness / mass) * std::sin(std::numbers::pi / (2.0 * (2.0 * discs + 1.0)));
}

std::array<double, 2> pair_frequencies(const PressedPair& pair) {
  const double a = pair.mass_below, b = pair.mass_above;
  const double root = std::sqrt(a * a - a * b + b * b);
  // Sum and root give the larger solution of the quadratic; the product of both is 3 k^2/(m_1 m_2).
  const double larger = pair.stiffness * (a + b + root) / (a * b);
  const double smaller = 3.0 * pair.stiffness / (a + b + root);
  return {std::sqrt(smaller), std::sqrt(larger)};
}

std::array<double, 2> pair_at_rest(const PressedPair& pair) {
  // Inverse of [2 -1; -1 2]: [2 1; 1 2]/3.
  const double unit = -pair.gravity / (3.0 * pair.stiffness);
  return {unit * (2.0 * pair.mass_below + pair.mass_above), unit * (pair.mass_below + 2.0 * pair.mass_above)};
}

PressedPairState pair_at(const PressedPair& pair, const PressedPairState& start, double t) {
  const std::array<double, 2> rest = pair_at_rest(pair);
  PressedPairState found{rest, {}};
  for (const double w : pair_frequencies(pair)) {
    const double xi = 0.5 * pair.lag * w;
    if (!(xi < 1.0)) throw std::invalid_argument("pressed_discs: a mode that is not below critical damping");
    // First row of K p = w^2 M p: p = (k, 2k - w^2 m_1).
    const std::array<double, 2> shape{pair.stiffness, 2.0 * pair.stiffness - w * w * pair.mass_below};
    const double norm = pair.mass_below * shape[0] * shape[0] + pair.mass_above * shape[1] * shape[1];
    const auto along = [&](double below, double above) {
      return (pair.mass_below * shape[0] * below + pair.mass_above * shape[1] * above) / norm;
    };
    const double q = along(start.height[0] - rest[0], start.height[1] - rest[1]);
    const double v = along(start.rate[0], start.rate[1]) / w;
    const double s = std::sqrt((1.0 - xi) * (1.0 + xi));
    const double decay = std::exp(-xi * w * t), c = std::cos(s * w * t), sine = std::sin(s * w * t) / s;
    const double height = decay * (q * c + (v + xi * q) * sine);
    const double rate = w * decay * (v * c - (xi * v + q) * sine);
    for (std::size_t i = 0; i < 2; ++i) {
      found.height[i] += shape[i] * height;
      found.rate[i] += shape[i] * rate;
    }
  }
  return found;
}

}  // namespace talus::verification::reference
