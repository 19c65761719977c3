#pragma once

#include "solver/base/archive.hpp"
#include "solver/scenes/fence_summary.hpp"

/// Comparison of a fence's summary with independently computed values, for the case `second_rock`.
namespace talus::verification::problems {

/// Observes a run of a fence with one layer: its summary, a second summary that is resumed during the run, and heights,
/// computed here from poses.
class WatchedSummary {
 public:
  /// The second summary is resumed at the first step from `stop` [T] on. All other arguments must outlive this object.
  WatchedSummary(const scenes::Fence& fence, const scenes::FenceScene& made, const Dynamics& dynamics, double stop);

  void operator()(const Snapshot& seen, const StepInfo& info);

  [[nodiscard]] const scenes::FenceSummary& summary() const { return watch_.summary(); }
  [[nodiscard]] const scenes::FenceSummary& resumed() const { return resumed_.summary(); }
  /// Number of values of the resumed summary and its history that differ from the first one; NaN if none was resumed.
  [[nodiscard]] double resumed_differences() const;
  /// Worst error of the layer's heights and the times of their extremes, and of the first rock's largest height and its
  /// distance from the fence [L or T].
  [[nodiscard]] double height_error() const;
  /// Worst error of the largest tensions, and of the largest hanger force, in the history's rows [F].
  [[nodiscard]] double tension_error() const { return tension_error_; }
  [[nodiscard]] double hanger_error() const { return hanger_error_; }

 private:
  void take_heights(const Snapshot& seen);
  double largest_hanger(const Snapshot& seen) const;

  const scenes::Fence* fence_;
  const Model* model_;
  scenes::FenceMonitor watch_, resumed_;
  double stop_{}, tension_error_{}, hanger_error_{}, at_resume_{}, rock_height_{}, rock_distance_{};
  ArchiveItems saved_;
  scenes::LayerRecord heights_;
  bool started_{false};
};

}  // namespace talus::verification::problems
