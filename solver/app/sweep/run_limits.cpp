#include "solver/app/sweep/run_limits.hpp"

#include <fmt/format.h>

#include <utility>

namespace talus::app {

RunLimits::RunLimits(const SweepLimits& limits, std::function<bool()> interrupted, long stride,
                     std::function<Clock::time_point()> now)
    : limits_{limits}, interrupted_{std::move(interrupted)}, stride_{stride}, now_{std::move(now)}, start_{now_()} {}

bool RunLimits::reached(long evaluations) {
  if (limits_.evaluations > 0 && evaluations >= limits_.evaluations)
    reason_ = fmt::format("limit of {} evaluations", limits_.evaluations);
  if (++calls_ % stride_ == 0) {
    is_interrupted_ = interrupted_();
    const std::chrono::duration<double> elapsed = now_() - start_;
    if (limits_.time > 0.0 && elapsed.count() > limits_.time) reason_ = fmt::format("limit of {} s", limits_.time);
  }
  return is_interrupted_ || !reason_.empty();
}

}  // namespace talus::app
