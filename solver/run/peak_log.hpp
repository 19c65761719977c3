#pragma once

#include <array>
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
/// and the last state are no maxima.
class PeakLog {
 public:
  /// The value of the next state. Times must increase.
  void add(double time, double value);

  const std::vector<Peak>& peaks() const { return peaks_; }

 private:
  std::vector<Peak> peaks_;
  /// The states that a maximum needs: the last before the present value was reached, the first and the last with it.
  Peak before_, first_, last_;
  int states_{};       ///< number of consecutive states with the present value
  bool has_before_{};  ///< there is a state with another value
};

}  // namespace talus
