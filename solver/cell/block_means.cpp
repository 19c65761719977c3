#include "solver/cell/block_means.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace talus {
namespace {

constexpr int all_drawn = 400;

/// Autocovariance of a series about its mean, at a lag.
double autocovariance(std::span<const double> series, double mean, std::size_t lag) {
  double sum = 0.0;
  for (std::size_t k = 0; k + lag < series.size(); ++k)
    sum += (series[k] - mean) * (series[k + lag] - mean);
  return sum / static_cast<double>(series.size());
}

}  // namespace

std::size_t block_length(std::span<const double> series) {
  const auto count = static_cast<double>(series.size());
  if (series.size() < 4) return 1;
  const double mean = std::accumulate(series.begin(), series.end(), 0.0) / count;
  const double variance = autocovariance(series, mean, 0);
  if (!(variance > 0.0)) return 1;
  // Finds the first lag after which `quiet` successive ones are within twice the standard deviation of an uncorrelated
  // series.
  const auto quiet = static_cast<std::size_t>(std::max(5.0, std::ceil(std::sqrt(std::log10(count)))));
  const std::size_t furthest =
      std::min(series.size() - 1, static_cast<std::size_t>(std::ceil(std::sqrt(count))) + quiet);
  const double chance = 2.0 * std::sqrt(std::log10(count) / count) * variance;
  std::size_t last = 0;  // lag with a significant autocovariance
  for (std::size_t lag = 1; lag <= furthest && lag <= last + quiet; ++lag)
    if (std::abs(autocovariance(series, mean, lag)) >= chance) last = lag;
  const std::size_t window = std::min(2 * std::max<std::size_t>(last, 1), furthest);
  double spectrum = variance, slope = 0.0;  // at frequency 0
  for (std::size_t lag = 1; lag <= window; ++lag) {
    const double fraction = static_cast<double>(lag) / static_cast<double>(window);
    const double part = 2.0 * (fraction <= 0.5 ? 1.0 : 2.0 * (1.0 - fraction)) * autocovariance(series, mean, lag);
    spectrum += part, slope += part * static_cast<double>(lag);
  }
  // If successive blocks compensate each other, the spectrum nearly vanishes at frequency 0.
  const double maximum = std::max(1.0, std::min(3.0 * std::sqrt(count), count / 3.0));
  const double length = spectrum > 0.0 ? std::cbrt(1.5 * slope * slope / (spectrum * spectrum) * count) : maximum;
  return static_cast<std::size_t>(std::lround(std::clamp(length, 1.0, maximum)));
}

BlockMeans::BlockMeans(std::size_t quantities, double time, std::size_t blocks)
    : quantities_{quantities},
      block_time_{time / static_cast<double>(blocks)},
      weight_(blocks),
      sums_(blocks * quantities) {}

void BlockMeans::add(double t, double weight, std::span<const double> values) {
  const double position = std::clamp(t / block_time_, 0.0, static_cast<double>(blocks() - 1));
  const auto block = static_cast<std::size_t>(position);
  weight_[block] += weight;
  for (std::size_t k = 0; k < quantities_; ++k)
    sums_[block * quantities_ + k] += weight * values[k];
}

double BlockMeans::block_mean(std::size_t block, std::size_t quantity) const {
  return weight_[block] > 0.0 ? sum(block, quantity) / weight_[block] : 0.0;
}

std::size_t BlockMeans::reached() const {
  std::size_t last = blocks();
  while (last > 0 && !seen(last - 1))
    --last;
  return last;
}

double BlockMeans::mean(std::size_t quantity, std::size_t first, std::size_t last) const {
  double weight = 0.0, total = 0.0;
  for (std::size_t block = first; block < last; ++block)
    weight += weight_[block], total += sum(block, quantity);
  return weight > 0.0 ? total / weight : 0.0;
}

Estimate BlockMeans::estimate(std::size_t first, const std::function<double(const Means&)>& of) const {
  // A run that has not ended counts as far as it has come.
  const std::size_t last = std::max(first, reached()), count = last - first;
  std::vector<double> sums(quantities_);
  double time = 0.0;
  const auto add = [&](std::size_t block, double times) {
    time += times * weight_[block];
    for (std::size_t k = 0; k < quantities_; ++k)
      sums[k] += times * sum(block, k);
  };
  for (std::size_t block = first; block < last; ++block)
    add(block, 1.0);
  const double value = of({sums, time});
  if (count < 2 || !std::isfinite(value)) return {value, 0.0};
  // The influence of each block on the value is the series whose correlation determines the block length.
  std::vector<double> without(count);
  const std::vector<double> all = sums;
  const double all_time = time;
  for (std::size_t k = 0; k < count; ++k) {
    add(first + k, -1.0);
    without[k] = of({sums, time});
    if (!std::isfinite(without[k])) without[k] = value;
    sums = all, time = all_time;
  }
  const std::size_t length = block_length(without);
  std::mt19937_64 random{count};
  double mean = 0.0, squares = 0.0, finite = 0.0;
  for (int s = 0; s < all_drawn; ++s) {
    std::fill(sums.begin(), sums.end(), 0.0), time = 0.0;
    for (std::size_t drawn = 0; drawn < count;) {
      const std::size_t start = random() % count;
      for (std::size_t k = 0; k < length && drawn < count; ++k, ++drawn)
        add(first + (start + k) % count, 1.0);
    }
    const double drawn = of({sums, time}) - value;
    if (std::isfinite(drawn)) mean += drawn, squares += drawn * drawn, finite += 1.0;
  }
  if (finite == 0.0) return {value, 0.0};
  mean /= finite, squares /= finite;
  // Deviations are from the mean of the blocks themselves, which is closer to them than the true mean: the variance
  // lacks the fraction length/count.
  const double missing = static_cast<double>(count) / static_cast<double>(count - length);
  return {value, std::sqrt(std::max(0.0, squares - mean * mean) * missing)};
}

Estimate BlockMeans::estimate(std::size_t quantity, std::size_t first) const {
  return estimate(first, [&](const Means& mean) { return mean(quantity); });
}

Estimate BlockMeans::ratio(std::size_t over, std::size_t under, std::size_t first) const {
  return estimate(first, [&](const Means& mean) {
    return mean(under) != 0.0 ? mean(over) / mean(under) : std::numeric_limits<double>::quiet_NaN();
  });
}

void BlockMeans::serialize(Archive& archive) {
  archive.numbers("weight", weight_);
  archive.numbers("sums", sums_);
}

}  // namespace talus
