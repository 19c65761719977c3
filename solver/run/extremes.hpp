#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "solver/base/archive.hpp"

namespace talus {

/// Minimum and maximum of a quantity over a run, and the first time of each.
struct Extreme {
  double least{};
  double least_time{};
  double largest{};
  double largest_time{};
};

/// The extremes of many quantities, stored as one array for each number.
class Extremes {
 public:
  /// Adds the values at one time; their number must not change. Later NaN values are ignored.
  void add(double time, std::span<const double> values);

  std::size_t size() const { return least_.size(); }
  Extreme operator[](std::size_t i) const { return {least_[i], least_time_[i], largest_[i], largest_time_[i]}; }

  /// Serializes the extremes of `count` quantities.
  void serialize(Archive& archive, std::size_t count);

 private:
  std::vector<double> least_, least_time_, largest_, largest_time_;
};

}  // namespace talus
