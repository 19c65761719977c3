#include "verification/reference/outlines/rocking_block.hpp"

#include <cmath>

namespace talus::verification::reference {
namespace {

double diagonal(const RockingBlock& block) { return std::hypot(block.half_width, block.half_height); }

}  // namespace

double block_angle(const RockingBlock& block) { return std::atan2(block.half_width, block.half_height); }

double block_rate(const RockingBlock& block) { return std::sqrt(0.75 * block.gravity / diagonal(block)); }

double fall_time(const RockingBlock& block, double tilt) {
  const double alpha = block_angle(block);
  // cos(alpha - q0) - cos(alpha - q) = 2 sin(alpha - q + (q - q0)/2) sin((q0 - q)/2), with q0 - q = q0 u^2.
  const auto integrand = [&](double u) {
    const double half = 0.5 * tilt * u * u;
    const double ratio = half == 0.0 ? 1.0 : std::sin(half) / half;
    return 2.0 * tilt / std::sqrt(2.0 * tilt * ratio * std::sin(alpha - tilt + half));
  };
  constexpr int pieces = 2000;
  double sum = integrand(0.0) + integrand(1.0);
  for (int i = 1; i < pieces; ++i)
    sum += (i % 2 == 1 ? 4.0 : 2.0) * integrand(static_cast<double>(i) / pieces);
  return sum / (3.0 * pieces * block_rate(block));
}

double slender_fall_time(const RockingBlock& block, double tilt) {
  return std::acosh(1.0 / (1.0 - tilt / block_angle(block))) / block_rate(block);
}

double impact_energy_ratio(const RockingBlock& block) {
  const double sine = std::sin(block_angle(block)), kept = 1.0 - 1.5 * sine * sine;
  return kept * kept;
}

double tilt_energy(const RockingBlock& block, double tilt) {
  const double alpha = block_angle(block);
  return block.gravity * diagonal(block) * 2.0 * std::sin(alpha - 0.5 * tilt) * std::sin(0.5 * tilt);
}

}  // namespace talus::verification::reference
