#pragma once

#include <optional>

#include "solver/run/observer.hpp"

namespace talus {

/// A moment at which a coordinate turns back.
struct TurningPoint {
  double time{};   ///< [T]
  double value{};  ///< the coordinate there
};

/// An observer that finds the first time at which a coordinate's velocity falls from positive to zero or below.
/// Between steps the coordinate is taken as the cubic through both ends' positions and velocities (Hermite), which is
/// exact to fourth order in the step and needs no acceleration.
class TurningPointFinder {
 public:
  explicit TurningPointFinder(std::size_t coordinate) : coordinate_{coordinate} {}

  void operator()(const State& state, const StepInfo& info);
  const std::optional<TurningPoint>& found() const { return found_; }

 private:
  std::size_t coordinate_;
  double t_{}, q_{}, v_{};  // at the step before
  std::optional<TurningPoint> found_;
};

}  // namespace talus
