#include "verification/reference/integration/stepped_latch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::verification::reference {
namespace {

constexpr double quarter = 0.5 * std::numbers::pi;

double unloading_step(const SteppedLatch& latch) { return latch.step / std::sqrt(latch.ratio); }

double fraction(double x) { return x - std::floor(x); }
double gamma(double phase) { return phase * (1.0 - phase); }

double determinant(StepMap map, double z) {
  return map == StepMap::euler ? 1.0 + z * z : map == StepMap::taylor ? 1.0 + 0.5 * z * z : 1.0;
}

/// Number of steps from x = 0 to v = 0 (`direction` 1), or back (-1).
double quarter_in_steps(StepMap map, double z, double direction) {
  const double trace = map == StepMap::euler ? 2.0 : map == StepMap::taylor ? 2.0 - 0.5 * z * z : 2.0 - z * z;
  const double angle = std::acos(0.5 * trace / std::sqrt(determinant(map, z)));
  const double tilt = map == StepMap::taylor ? std::asin(0.25 * z) : 0.0;
  return (quarter + direction * tilt) / angle;
}

/// ln of the growth of the amplitude until the contact ends.
double growth(const SteppedLatch& latch) {
  const double z1 = latch.step, z2 = unloading_step(latch);
  return 0.5 * std::log(determinant(latch.map, z1)) * quarter_in_steps(latch.map, z1, 1.0) +
         0.5 * std::log(determinant(latch.map, z2)) * quarter_in_steps(latch.map, z2, -1.0);
}

}  // namespace

double leading_restitution(const SteppedLatch& latch) {
  const double c = latch.map == StepMap::euler ? 0.25 : latch.map == StepMap::taylor ? 0.125 : 0.0;
  return std::sqrt(latch.ratio) * std::exp(c * std::numbers::pi * (latch.step + unloading_step(latch)));
}

double mean_restitution(const SteppedLatch& latch) {
  const double z1 = latch.step, z2 = unloading_step(latch);
  if (z2 >= 2.0) return NAN;
  const double of_phases = latch.map == StepMap::taylor ? (z2 * z2 - z1 * z1) / 8.0 : 0.0;
  return std::sqrt(latch.ratio) * std::exp(growth(latch) + of_phases);
}

double stepped_restitution(const SteppedLatch& latch, double phase) {
  const double z1 = latch.step, z2 = unloading_step(latch);
  const double shift = latch.map == StepMap::leapfrog ? 0.5 : 0.0;
  const double at_top = phase + quarter_in_steps(latch.map, z1, 1.0);
  const double turn = fraction(at_top + shift), end = fraction(at_top + quarter_in_steps(latch.map, z2, -1.0));
  const double nearer = std::min(turn, 1.0 - turn);
  const double at_turn = latch.map == StepMap::taylor ? nearer * nearer : -gamma(turn);
  const double of_phase = 0.5 * (z2 * z2 * gamma(end) - z1 * z1 * gamma(phase) + (z2 * z2 - z1 * z1) * at_turn);
  return std::sqrt(latch.ratio) * std::exp(growth(latch) + of_phase);
}

}  // namespace talus::verification::reference
