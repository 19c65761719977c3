#pragma once

#include <optional>

#include "solver/run/observer.hpp"

namespace talus {

/// Time and value at which a coordinate reverses.
struct TurningPoint {
  double time{};   ///< [T]
  double value{};  ///< value of the coordinate
};

/// Observer that finds the first time at which a coordinate's velocity falls from positive to zero or below. Between
/// steps the coordinate is interpolated by the cubic through positions and velocities at both ends (Hermite), which is
/// accurate to fourth order in the step and needs no acceleration.
class TurningPointFinder {
 public:
  explicit TurningPointFinder(std::size_t coordinate) : coordinate_{coordinate} {}

  void operator()(const State& state, const StepInfo& info);
  const std::optional<TurningPoint>& found() const { return found_; }

 private:
  std::size_t coordinate_;
  double t_{}, q_{}, v_{};  // at the previous step
  std::optional<TurningPoint> found_;
};

}  // namespace talus
