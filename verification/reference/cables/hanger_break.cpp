#include "verification/reference/cables/hanger_break.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace talus::verification::reference {
namespace {

/// Mode of the pair, in coordinates scaled by the square roots of the masses.
struct Swing {
  double frequency{};
  double b{}, c{};  ///< displacement amplitudes for the initial state, times the frequency [L/T]
};

std::array<Swing, 2> swings(const HungPair& p) {
  const double kbb = (p.stiffness_1 + p.stiffness_2) / p.mass_b, kcc = p.stiffness_2 / p.mass_c;
  const double kbc = -p.stiffness_2 / std::sqrt(p.mass_b * p.mass_c);
  const double mean = 0.5 * (kbb + kcc), half = std::hypot(0.5 * (kbb - kcc), kbc);
  std::array<Swing, 2> found{};
  for (std::size_t i = 0; i < 2; ++i) {
    // Smaller root without cancellation.
    const double large = mean + half;
    const double root = i == 0 ? large : p.stiffness_1 * p.stiffness_2 / (p.mass_b * p.mass_c) / large;
    // Eigenvector from (kbb - root) yb + kbc yc = 0 or from the other row: the longer of the two.
    double yb = -kbc, yc = kbb - root;
    if (std::abs(kcc - root) > std::abs(yc)) {
      yb = kcc - root;
      yc = -kbc;
    }
    const double norm = std::hypot(yb, yc);
    const double ratio = yc / norm * std::sqrt(p.mass_c) * p.speed;
    found[i] = {std::sqrt(root), ratio * yb / norm / std::sqrt(p.mass_b), ratio * yc / norm / std::sqrt(p.mass_c)};
  }
  return found;
}

/// Zero crossing of f between low and high, rising or falling.
template <class F>
double crossing(F&& f, double low, double high) {
  const bool from = f(low) < 0.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) < 0.0) == from ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

PairState held_pair(const HungPair& pair, double t) {
  PairState state;
  for (const Swing& swing : swings(pair)) {
    const double s = std::sin(swing.frequency * t) / swing.frequency, c = std::cos(swing.frequency * t);
    state.b += swing.b * s;
    state.c += swing.c * s;
    state.speed_b += swing.b * c;
    state.speed_c += swing.c * c;
  }
  return state;
}

double hanger_load(const HungPair& pair, const PairState& state) {
  return pair.stiffness_2 * (state.c - state.b) - pair.stiffness_1 * state.b;
}

LoadPeak first_load_peak(const HungPair& pair) {
  const auto rate = [&](double t) {
    const PairState s = held_pair(pair, t);
    return pair.stiffness_2 * (s.speed_c - s.speed_b) - pair.stiffness_1 * s.speed_b;
  };
  const double step = 0.01 / swings(pair)[0].frequency;
  double t = step;
  while (rate(t) > 0.0)
    t += step;
  const double peak = crossing(rate, t - step, t);
  const PairState at_peak = held_pair(pair, peak);
  if (!(at_peak.b > 0.0 && at_peak.c > at_peak.b)) throw std::logic_error("hanger_break: a cable is slack at the peak");
  return {hanger_load(pair, at_peak), peak};
}

HangerBreak break_hanger(const HungPair& pair, double strength) {
  const LoadPeak peak = first_load_peak(pair);
  if (!(strength > 0.0 && strength < peak.load))
    throw std::invalid_argument("hanger_break: the strength must be > 0 and below the first peak of the load");
  HangerBreak found;
  found.time = crossing([&](double t) { return hanger_load(pair, held_pair(pair, t)) - strength; }, 0.0, peak.time);
  found.at_break = held_pair(pair, found.time);
  found.lost = 0.5 * strength * strength / (pair.stiffness_1 + pair.stiffness_2);
  found.merged_stiffness = pair.stiffness_1 * pair.stiffness_2 / (pair.stiffness_1 + pair.stiffness_2);
  const double w = std::sqrt(found.merged_stiffness / pair.mass_c);
  const PairState& at = found.at_break;
  found.exit_speed_c = std::hypot(at.speed_c, w * at.c);
  // c = A sin(w tau + phase), slack at phase pi.
  found.slack_time = found.time + (std::acos(-1.0) - std::atan2(w * at.c, at.speed_c)) / w;
  return found;
}

PairState parted_pair(const HungPair& pair, const HangerBreak& broken, double t) {
  const double w = std::sqrt(broken.merged_stiffness / pair.mass_c), tau = t - broken.time;
  const double s = std::sin(w * tau), c = std::cos(w * tau);
  const PairState& at = broken.at_break;
  return {at.b + at.speed_b * tau, at.c * c + at.speed_c / w * s, at.speed_b, at.speed_c * c - at.c * w * s};
}

}  // namespace talus::verification::reference
