#include "verification/reference/friction/oblique_impact.hpp"

#include <cmath>
#include <stdexcept>

namespace talus::verification::reference {
namespace {

using Phase = ObliqueRebound::Phase;

/// The impact along the normal, xi < 1.
class Normal {
 public:
  explicit Normal(const Impact& impact)
      : impact_{impact},
        w_{std::sqrt(impact.stiffness / impact.effective_mass)},
        xi_{impact.damping / (2.0 * w_ * impact.effective_mass)},
        s_{std::sqrt((1.0 - xi_) * (1.0 + xi_))} {}

  double depth(double t) const { return decay(t) * std::sin(s_ * w_ * t) / (s_ * w_); }
  double rate(double t) const { return decay(t) * (std::cos(s_ * w_ * t) - xi_ / s_ * std::sin(s_ * w_ * t)); }
  double force(double t) const { return impact_.stiffness * depth(t) + impact_.damping * rate(t); }
  double force_rate(double t) const {
    return impact_.stiffness * rate(t) - impact_.damping * force(t) / impact_.effective_mass;
  }

 private:
  double decay(double t) const { return impact_.approach_speed * std::exp(-xi_ * w_ * t); }
  Impact impact_;
  double w_, xi_, s_;
};

class Solution {
 public:
  Solution(const ObliqueImpact& impact, double end)
      : impact_{impact},
        normal_{impact.normal},
        end_{end},
        frequency_{std::sqrt(impact.mobility * impact.tangential_stiffness / impact.normal.effective_mass)} {}

  /// Integrates phase by phase to the end of friction.
  ObliqueRebound solve() const {
    ObliqueRebound found;
    Phase phase{0.0, 0, impact_.slip_rate, 0.0};
    if (slips_at_once(phase)) phase.slips = phase.slip_rate > 0.0 ? 1 : -1;
    double until = 0.0;
    do {
      found.phases.push_back(phase);
      until = end_of(phase);
      found.dissipated += dissipated(phase, until);
      phase = next(phase, until);
    } while (until < end_);
    found.slip_rate = phase.slip_rate;
    found.speed_lost = (impact_.slip_rate - phase.slip_rate) / impact_.mobility;
    return found;
  }

 private:
  double limit(double t) const { return impact_.friction * normal_.force(t) / impact_.tangential_stiffness; }
  double limit_rate(double t) const { return impact_.friction * normal_.force_rate(t) / impact_.tangential_stiffness; }

  bool slips_at_once(const Phase& phase) const {
    return limit(0.0) == 0.0 && std::abs(phase.slip_rate) > limit_rate(0.0);
  }

  double rate_at(const Phase& phase, double t) const {
    if (phase.slips != 0) {
      const double shed = normal_.rate(phase.begin) - normal_.rate(t);
      return phase.slip_rate - phase.slips * impact_.mobility * impact_.friction * shed;
    }
    const double angle = frequency_ * (t - phase.begin);
    return phase.slip_rate * std::cos(angle) - phase.stretch * frequency_ * std::sin(angle);
  }

  double stretch_at(const Phase& phase, double t) const {
    if (phase.slips != 0) return phase.slips * limit(t);
    const double angle = frequency_ * (t - phase.begin);
    return phase.stretch * std::cos(angle) + phase.slip_rate / frequency_ * std::sin(angle);
  }

  /// Positive while the phase lasts.
  double guard(const Phase& phase, double t) const {
    if (phase.slips != 0) return phase.slips * rate_at(phase, t) - limit_rate(t);
    return limit(t) - std::abs(stretch_at(phase, t));
  }

  double end_of(const Phase& phase) const {
    constexpr int grid = 4000;
    // Two oscillations in phase are at the limit all along, except for round-off.
    const double noise = phase.slips != 0 ? 0.0 : -1e-13 * impact_.normal.approach_speed / frequency_;
    double low = phase.begin;
    for (int i = static_cast<int>(phase.begin / end_ * grid) + 1; i <= grid; ++i) {
      double high = i == grid ? end_ * (1.0 - 1e-12) : end_ * i / grid;
      if (high <= phase.begin) continue;
      if (guard(phase, high) >= noise) {
        low = high;
        continue;
      }
      for (int j = 0; j < 60; ++j) {
        const double middle = 0.5 * (low + high);
        (guard(phase, middle) >= 0.0 ? low : high) = middle;
      }
      return high;
    }
    return end_;
  }

  /// mu N (v - N' mu/k_s) over the phase, by Simpson's rule on 2000 intervals: error of order 1e-14 of the result.
  double dissipated(const Phase& phase, double until) const {
    if (phase.slips == 0) return 0.0;
    constexpr int pieces = 2000;
    const double h = (until - phase.begin) / (2 * pieces);
    double sum = 0.0;
    for (int i = 0; i <= 2 * pieces; ++i) {
      const double t = phase.begin + h * i;
      const double weight = i == 0 || i == 2 * pieces ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += weight * impact_.friction * normal_.force(t) * guard(phase, t);
    }
    return sum * h / 3.0;
  }

  Phase next(const Phase& phase, double t) const {
    const double rate = rate_at(phase, t), stretch = stretch_at(phase, t);
    const int outward = stretch > 0.0 ? 1 : -1;
    return {t, phase.slips != 0 ? 0 : outward, rate, stretch};
  }

  ObliqueImpact impact_;
  Normal normal_;
  double end_;
  double frequency_;
};

}  // namespace

ObliqueRebound rebound(const ObliqueImpact& impact, EndRule end) {
  if (!(impact.tangential_stiffness > 0.0 && impact.friction >= 0.0 && impact.mobility >= 1.0))
    throw std::invalid_argument("oblique_impact: k_s must be > 0, mu >= 0, n >= 1");
  const ImpactEvents pushes = impact_events(impact.normal, EndRule::clamped);
  if (!(pushes.damping_ratio < 1.0)) throw std::invalid_argument("oblique_impact: the damping ratio must be < 1");
  ObliqueRebound found = Solution{impact, pushes.contact_time}.solve();
  found.separation = restitution(pushes.damping_ratio, end) * impact.normal.approach_speed;
  return found;
}

double speed_lost_by_gross_sliding(double friction, double restitution, double approach_speed) {
  return friction * (1.0 + restitution) * approach_speed;
}

double full_stick_ratio(const ObliqueImpact& impact) {
  return impact.friction * impact.normal.stiffness / impact.tangential_stiffness;
}

}  // namespace talus::verification::reference
