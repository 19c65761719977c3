#include "solver/run/peak_log.hpp"

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
  if (states_ > 0 && value == last_.value) {
    last_ = {time, value};
    ++states_;
    return;
  }
  if (states_ > 0 && has_before_ && before_.value < last_.value && value < last_.value) {
    if (states_ == 1) {
      peaks_.push_back(vertex(before_, last_, {time, value}));
    } else if (states_ == 2) {
      peaks_.push_back(vertex(before_, first_, last_));
    } else {
      peaks_.push_back({0.5 * (first_.time + last_.time), last_.value});
    }
  }
  if (states_ > 0) before_ = last_, has_before_ = true;
  first_ = last_ = {time, value};
  states_ = 1;
}

}  // namespace talus
