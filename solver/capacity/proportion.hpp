#pragma once

#include <cstddef>
#include <vector>

namespace talus {

/// An interval of confidence.
struct Interval {
  double low{}, high{};
};

/// Standard normal quantile of 97.5 %, for two-sided intervals of 95 %.
inline constexpr double normal_975 = 1.959963984540054;

/// Interval of 95 % for a probability after `hits` of `trials` independent trials: all probabilities p from which the
/// observed proportion is at most 1.96 sqrt(p (1 - p)/trials) away (Wilson 1927, J. Amer. Statist. Assoc. 22, 209).
/// Without trials it is [0, 1].
[[nodiscard]] Interval wilson_interval(std::size_t hits, std::size_t trials);

/// A quantile of a sample with its interval.
struct SampleQuantile {
  double value{};
  Interval interval;
};

/// The quantile of a probability in (0, 1): the sample's value at that fraction of its ranks, linear between two, and
/// the interval between two of its values within which the quantile of the distribution is with at least 95 %,
/// whatever the distribution (number of values below it: binomial). An end of which a sample this small knows nothing
/// is infinite. `sample`: in any order, at least one value.
[[nodiscard]] SampleQuantile sample_quantile(std::vector<double> sample, double probability);

}  // namespace talus
