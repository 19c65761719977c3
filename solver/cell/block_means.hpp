#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "solver/base/archive.hpp"

namespace talus {

/// A mean and its standard error.
struct Estimate {
  double value{};
  double error{};
};

/// Block length for a circular block bootstrap of the mean of a series that minimizes the error of the standard error.
/// It is computed from the autocorrelations, up to the lag where they vanish within statistical scatter, by a flat-top
/// window (Politis & White 2004, as corrected by Patton, Politis & White 2009); at most a third of the series.
[[nodiscard]] std::size_t block_length(std::span<const double> series);

/// Time averages of several quantities that are sampled together, with standard errors from blocks of equal time,
/// because successive samples are correlated.
class BlockMeans {
 public:
  /// quantities: number of quantities; time [T]: duration of the run, which is divided into blocks.
  BlockMeans(std::size_t quantities, double time, std::size_t blocks);

  /// Adds a sample at time t since the start of the run that represents `weight` > 0 of time [T].
  void add(double t, double weight, std::span<const double> values);

  std::size_t blocks() const { return weight_.size(); }
  bool seen(std::size_t block) const { return weight_[block] > 0.0; }
  /// The number of blocks up to the last one with a sample.
  std::size_t reached() const;
  /// Mean in one block; 0 for a block without a sample.
  double block_mean(std::size_t block, std::size_t quantity) const;

  /// Mean of a quantity over the blocks [first, last).
  double mean(std::size_t quantity, std::size_t first, std::size_t last) const;

  /// Means over some blocks; NaN if these have no sample.
  struct Means {
    std::span<const double> sums;
    double time{};
    double operator()(std::size_t quantity) const {
      return time > 0.0 ? sums[quantity] / time : std::numeric_limits<double>::quiet_NaN();
    }
  };
  /// Function of the means over all blocks from `first` on, with the standard error from a circular block bootstrap
  /// (Politis & Romano 1992): 400 series of the same number of blocks, drawn as sequences of neighbours from a fixed
  /// seed. The length of a sequence follows from the correlation of the series (block_length). An undefined estimate,
  /// such as a ratio to a mean that is zero, is NaN; series that give NaN do not count.
  Estimate estimate(std::size_t first, const std::function<double(const Means&)>& of) const;
  /// Mean of a quantity; ratio of the means of two quantities.
  Estimate estimate(std::size_t quantity, std::size_t first) const;
  Estimate ratio(std::size_t over, std::size_t under, std::size_t first) const;

  void serialize(Archive& archive);

 private:
  double sum(std::size_t block, std::size_t quantity) const { return sums_[block * quantities_ + quantity]; }

  std::size_t quantities_;
  double block_time_;
  std::vector<double> weight_;  ///< sampled time of each block [T]
  std::vector<double> sums_;    ///< of weight times value, block by block
};

}  // namespace talus
