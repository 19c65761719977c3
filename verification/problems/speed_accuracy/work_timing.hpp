#pragma once

#include <string>
#include <vector>

#include "verification/problems/speed_accuracy/work_charts.hpp"

/// Time against error: pictures of this machine on which nothing is checked. For the full tier.
namespace talus::verification::problems {

/// Nanoseconds of one run, without output and ledger: the median of 15 repetitions, all methods and points of a scene
/// interleaved in a shuffled order, with the fastest and the slowest.
struct TimedPoint {
  std::string scene, quantity, method;
  double error{};
  double median{}, fastest{}, slowest{};  ///< [ns]
};

/// Of all points of the curves of one scene that did not fail and take at most 100,000 evaluations.
[[nodiscard]] std::vector<TimedPoint> timed_points(const SceneCurves& curves);

/// One row for each point.
[[nodiscard]] DataFile timing_data(const std::vector<TimedPoint>& points, const std::string& machine);

/// A chart for each scene and quantity of the data: time against error, medians with bars from fastest to slowest.
[[nodiscard]] std::vector<Figure> timing_figures(const DataFile& data, const std::string& machine);

}  // namespace talus::verification::problems
