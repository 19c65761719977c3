#include "verification/reference/impacts/latching_impact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace talus::verification::reference {

LatchingEvents latching_events(const LatchingImpact& impact) {
  if (!(impact.loading > 0.0 && impact.unloading >= impact.loading && impact.growth >= 0.0 &&
        impact.effective_mass > 0.0 && impact.approach_speed > 0.0))
    throw std::invalid_argument("latching_impact: needs 0 < K1 <= K, S >= 0, m > 0, v > 0");
  LatchingEvents found;
  found.loading_frequency = std::sqrt(impact.loading / impact.effective_mass);
  found.largest_depth = impact.approach_speed / found.loading_frequency;
  const double back = impact.unloading + impact.growth * impact.loading * found.largest_depth;
  found.unloading_frequency = std::sqrt(back / impact.effective_mass);
  found.restitution = std::sqrt(impact.loading / back);
  found.turn_time = 0.5 * std::numbers::pi / found.loading_frequency;
  found.contact_time = found.turn_time + 0.5 * std::numbers::pi / found.unloading_frequency;
  found.residual_depth = found.largest_depth * ((back - impact.loading) / back);
  return found;
}

DepthState latching_depth_at(const LatchingImpact& impact, double t) {
  const LatchingEvents at = latching_events(impact);
  if (t <= at.turn_time) {
    const double angle = at.loading_frequency * t;
    return {at.largest_depth * std::sin(angle), impact.approach_speed * std::cos(angle)};
  }
  const double exit = at.restitution * impact.approach_speed;
  if (t >= at.contact_time) return {at.residual_depth - exit * (t - at.contact_time), -exit};
  const double angle = at.unloading_frequency * (t - at.turn_time);
  return {at.residual_depth + exit / at.unloading_frequency * std::cos(angle), -exit * std::sin(angle)};
}

std::vector<double> latching_forces(const LatchingImpact& law, std::span<const double> path) {
  std::vector<double> forces;
  double largest = 0.0;
  for (const double depth : path) {
    largest = depth > 0.0 ? std::max(largest, depth) : 0.0;
    const double back = law.unloading + law.growth * law.loading * largest;
    const double latched = largest * (1.0 - law.loading / back);
    forces.push_back(std::max(0.0, std::min(law.loading * depth, back * (depth - latched))));
  }
  return forces;
}

}  // namespace talus::verification::reference
