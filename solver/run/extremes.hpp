#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/base/rows.hpp"

namespace talus {

/// Minimum and maximum of a quantity over a run, and the first time of each.
struct Extreme {
  double minimum{};
  double minimum_time{};
  double maximum{};
  double maximum_time{};
};

/// The extremes of many quantities, stored as one array for each number. Values are compared in blocks of several
/// times, so that extremes are loaded and stored once for each block.
class Extremes {
 public:
  /// Adds the values at one time; their number must not change. Later NaN values are ignored.
  void add(double time, std::span<const double> values);

  std::size_t size() const { return minimum_.size(); }
  Extreme operator[](std::size_t i) const;

  /// Serializes the extremes of `count` quantities.
  void serialize(Archive& archive, std::size_t count);

 private:
  void compare();

  std::vector<double> rows_;  ///< values that have not been compared yet, time by time
  std::array<double, block_rows> row_times_{};
  std::size_t pending_{};  ///< number of these rows
  std::vector<double> minimum_, minimum_time_, maximum_, maximum_time_;
};

}  // namespace talus
