#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solver/base/memory.hpp"

namespace talus {

/// A mean and its standard error.
struct Estimate {
  double value{};
  double error{};
};

/// Means over time of several quantities that are sampled together, in blocks of equal time, by which their errors are
/// told: what is sampled in a flow at one moment tells little that the moment before did not.
class BlockMeans {
 public:
  /// quantities: how many; time [T]: of the whole run, of which each block is one part.
  BlockMeans(std::size_t quantities, double time, std::size_t blocks);

  /// Adds a sample that stands for `weight` > 0 of time [T] at time t since the start of the run.
  void add(double t, double weight, std::span<const double> values);

  std::size_t blocks() const { return weight_.size(); }
  /// Mean in one block; 0 of a block without a sample.
  double block_mean(std::size_t block, std::size_t quantity) const;

  /// Mean of a quantity over the blocks [first, last).
  double mean(std::size_t quantity, std::size_t first, std::size_t last) const;

  /// The same of all blocks from `first` on, with the standard error of a circular block bootstrap (Politis & Romano
  /// 1992): 400 series of as many blocks, of runs of neighbours as long as the cube root of their number, from a seed
  /// of their own. No samples: zeros.
  Estimate estimate(std::size_t quantity, std::size_t first) const;
  /// Mean of one over mean of the other, drawn together.
  Estimate ratio(std::size_t over, std::size_t under, std::size_t first) const;

  void remember(Memory& memory);

 private:
  double sum(std::size_t block, std::size_t quantity) const { return sums_[block * quantities_ + quantity]; }

  std::size_t quantities_;
  double block_time_;
  std::vector<double> weight_;  ///< of each block
  std::vector<double> sums_;    ///< of weight times value, block by block
};

}  // namespace talus
