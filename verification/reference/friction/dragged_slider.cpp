#include "verification/reference/friction/dragged_slider.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace talus::verification::reference {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// First w t > 0 at which cos(w t - phase) rises through `level`; `never` if it does not reach it.
double rise(double level, double phase) {
  // An oscillation that only just reaches the level turns there.
  if (!(level < 1.0 - 1e-14)) return never;
  double angle = phase - std::acos(level);
  while (angle <= 1e-13)
    angle += 2.0 * std::numbers::pi;
  return angle;
}

}  // namespace

DraggedSliderMotion::DraggedSliderMotion(const DraggedSlider& problem, double until) : problem_{problem} {
  const bool fine = problem.mass > 0.0 && problem.mobility >= 1.0 && problem.normal_force > 0.0 &&
                    problem.friction > 0.0 && problem.tangential_stiffness > 0.0 && until >= 0.0;
  if (!fine) throw std::invalid_argument("dragged_slider: m, N, mu and k_s must be > 0, n >= 1, until >= 0");
  limit_ = problem.friction * problem.normal_force / problem.tangential_stiffness;
  if (std::abs(problem.stretch) > limit_) throw std::invalid_argument("dragged_slider: |s(0)| must be <= mu N/k_s");
  rest_ = problem.mass * problem.drive / (problem.mobility * problem.tangential_stiffness);
  frequency_ = std::sqrt(problem.mobility * problem.tangential_stiffness / problem.mass);
  Phase phase{0.0, slip_sign(problem.slip_rate, problem.stretch), problem.slip_rate, problem.stretch, 0.0};
  phases_.push_back(phase);
  for (double end = duration(phase); end < until; end = phase.begin + duration(phase)) {
    const bool slipped = phase.slips != 0;
    Phase next = state_in(phase, end);
    next.begin = end;
    if (slipped) {
      next.slip_rate = 0.0;
    } else {
      next.stretch = std::copysign(limit_, next.stretch);
    }
    next.slips = slip_sign(next.slip_rate, next.stretch);
    phases_.push_back(next);
    phase = next;
  }
}

/// Direction in which the slider slips from here; 0: it sticks.
int DraggedSliderMotion::slip_sign(double slip_rate, double stretch) const {
  if (std::abs(stretch) < limit_) return 0;
  const int outward = stretch > 0.0 ? 1 : -1;
  if (slip_rate * outward > 0.0) return outward;
  return slip_rate == 0.0 && (rest_ - stretch) * outward > 0.0 ? outward : 0;
}

double DraggedSliderMotion::duration(const Phase& phase) const {
  if (phase.slips != 0) {
    const double drag = problem_.mobility * problem_.friction * problem_.normal_force / problem_.mass;
    const double rate = problem_.drive - phase.slips * drag;
    return rate * phase.slips < 0.0 ? -phase.slip_rate / rate : never;
  }
  const double from_rest = phase.stretch - rest_, swing = phase.slip_rate / frequency_;
  const double amplitude = std::hypot(from_rest, swing);
  if (amplitude == 0.0) return never;
  const double up = rise((limit_ - rest_) / amplitude, std::atan2(swing, from_rest));
  const double down = rise((limit_ + rest_) / amplitude, std::atan2(-swing, -from_rest));
  return std::min(up, down) / frequency_;
}

DraggedSliderMotion::Phase DraggedSliderMotion::state_in(const Phase& phase, double t) const {
  const double tau = t - phase.begin;
  Phase now = phase;
  if (phase.slips != 0) {
    const double drag = problem_.mobility * problem_.friction * problem_.normal_force / problem_.mass;
    const double rate = problem_.drive - phase.slips * drag;
    now.slip_rate += rate * tau;
    now.slipped += std::abs(tau * (phase.slip_rate + 0.5 * rate * tau));
    return now;
  }
  const double c = std::cos(frequency_ * tau), s = std::sin(frequency_ * tau);
  now.stretch = rest_ + (phase.stretch - rest_) * c + phase.slip_rate / frequency_ * s;
  now.slip_rate = phase.slip_rate * c - (phase.stretch - rest_) * frequency_ * s;
  return now;
}

SliderState DraggedSliderMotion::at(double t) const {
  std::size_t i = phases_.size() - 1;
  while (i > 0 && phases_[i].begin > t)
    --i;
  const Phase now = state_in(phases_[i], t);
  const double pushed = problem_.slip_rate + problem_.drive * t - now.slip_rate;
  return {now.slip_rate, now.stretch, now.slipped, problem_.drive * t - pushed / problem_.mobility};
}

double swing_after_slip(const DraggedSlider& p) {
  return p.friction * p.normal_force * std::sqrt(p.mobility / (p.mass * p.tangential_stiffness));
}

}  // namespace talus::verification::reference
