#include "solver/run/peak_log.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus {
namespace {

/// Maximum of the parabola through three points; the middle one is not below the others, and above the first.
Peak vertex(const Peak& a, const Peak& b, const Peak& c) {
  const double rise = (b.value - a.value) / (b.time - a.time), fall = (c.value - b.value) / (c.time - b.time);
  const double curvature = (fall - rise) / (c.time - a.time);  // half the second derivative, < 0
  // The slope of the chord a-b is that of the parabola in its middle.
  const double time = 0.5 * (a.time + b.time) - 0.5 * rise / curvature;
  return {time, b.value - curvature * (time - b.time) * (time - b.time)};
}

}  // namespace

void PeakLog::add(double time, double value) {
  constexpr double round_off = 1e-12;
  const Peak now{time, value};
  scale_ = std::max(scale_, std::abs(value));
  const Peak before = std::exchange(previous_, now);
  const bool was_rising = is_rising_;
  if (!was_rising) {
    lowest_ = std::min(lowest_, value);
    is_rising_ = value > lowest_ + round_off * scale_;
    if (!is_rising_) return;
  }
  if (!was_rising || value > last_.value) {
    before_ = before, first_ = last_ = now, states_ = 1, has_after_ = false;
  } else if (value == last_.value && !has_after_) {
    last_ = now, ++states_;
  } else {
    if (!has_after_) after_ = now, has_after_ = true;
    if (value < last_.value - round_off * scale_) {
      peaks_.push_back(states_ == 1   ? vertex(before_, last_, after_)
                       : states_ == 2 ? vertex(before_, first_, last_)
                                      : Peak{0.5 * (first_.time + last_.time), last_.value});
      is_rising_ = false, lowest_ = value;
    }
  }
}

}  // namespace talus
