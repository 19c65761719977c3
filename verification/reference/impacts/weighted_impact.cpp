#include "verification/reference/impacts/weighted_impact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/reference/motion/damped_oscillator.hpp"

namespace talus::verification::reference {

WeightedRebound weighted_rebound(const WeightedImpact& impact, EndRule end) {
  const auto& [mass, stiffness, damping, gravity, speed] = impact;
  const double frequency = std::sqrt(stiffness / mass), rest = mass * gravity / stiffness;
  const DampedOscillator oscillator{frequency, damping / (2.0 * std::sqrt(stiffness * mass)), -rest, speed};
  const auto acts = [&](double t) {
    const OscillatorState state = state_at(oscillator, t);
    const double overlap = rest + state.displacement;
    return (end == EndRule::clamped ? impact.stiffness * overlap + impact.damping * state.velocity : overlap) > 0.0;
  };
  // A clamped force ends at the earliest (critical damping) at 2/frequency; each before a whole period.
  const double period = 2.0 * std::numbers::pi / (frequency * std::sqrt(1.0 - std::pow(oscillator.damping_ratio, 2)));
  double before = 0.5 * std::numbers::pi / frequency, after = before;
  // A weight soon closes the contact again: the first end is looked for in small parts of the period.
  while (acts(after)) {
    before = after, after += period / 4096.0;
    if (after > period) throw std::invalid_argument{"weighted_rebound: the force does not end"};
  }
  for (int halving = 0; halving < 60; ++halving) {
    const double t = 0.5 * (before + after);
    (acts(t) ? before : after) = t;
  }
  const OscillatorState released = state_at(oscillator, before);
  const double square = released.velocity * released.velocity - 2.0 * gravity * (rest + released.displacement);
  return {before, -released.velocity, std::sqrt(std::max(square, 0.0)) / speed};
}

}  // namespace talus::verification::reference
