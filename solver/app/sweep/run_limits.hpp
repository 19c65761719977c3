#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "solver/app/sweep/sweep_file.hpp"

namespace talus::app {

/// Decides when a run of a sweep must end before its time: at a limit of the sweep, or because it is interrupted.
class RunLimits {
 public:
  using Clock = std::chrono::steady_clock;

  /// The clock, whose time begins now, and the interruption are read at each `stride`-th call of reached().
  RunLimits(const SweepLimits& limits, std::function<bool()> interrupted, long stride,
            std::function<Clock::time_point()> now = Clock::now);

  /// Whether a run with this number of force evaluations must end.
  bool reached(long evaluations);

  bool is_interrupted() const { return is_interrupted_; }
  /// The limit that was reached, as text; empty if none was.
  const std::string& reason() const { return reason_; }

 private:
  SweepLimits limits_;
  std::function<bool()> interrupted_;
  long stride_, calls_{};
  std::function<Clock::time_point()> now_;
  Clock::time_point start_;
  bool is_interrupted_{};
  std::string reason_;
};

}  // namespace talus::app
