#pragma once

#include <limits>
#include <vector>

namespace talus {

/// A local maximum of a quantity over time.
struct Peak {
  double time{};   ///< [T]
  double value{};  ///< in the unit of the quantity
};

/// Local maxima of one quantity of a run, from its value in each state. A maximum lies between two states: it is that
/// of the parabola through the highest of them and its neighbours, exact for free flight and else with an error of
/// third order in their distance. Of a value that stays equal over more than two states it is the middle. The first
/// and the last state are no maxima, nor is a state from which the value falls by round-off alone, 1e-12 of the largest
/// absolute value so far.
class PeakLog {
 public:
  /// The value of the next state. Times must increase.
  void add(double time, double value);

  const std::vector<Peak>& peaks() const { return peaks_; }

 private:
  std::vector<Peak> peaks_;
  double scale_{};         ///< largest absolute value
  bool is_rising_{false};  ///< the value has risen since the last maximum, or the start
  double lowest_{std::numeric_limits<double>::infinity()};  ///< value since then
  /// The highest states since it rises: the one before them, the first and the last with their value, the next one.
  Peak before_, first_, last_, after_;
  int states_{};  ///< number of the highest states
  bool has_after_{};
  Peak previous_;
};

}  // namespace talus
