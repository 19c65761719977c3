#include "solver/granular/block_means.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace talus {
namespace {

constexpr int series = 400;

/// Standard deviation of what `of` says of drawn series of blocks.
template <class Of>
double bootstrap_error(std::size_t first, std::size_t last, Of&& of) {
  const std::size_t count = last - first;
  if (count < 2) return 0.0;
  const auto length = static_cast<std::size_t>(std::lround(std::cbrt(static_cast<double>(count))));
  std::mt19937_64 random{count};
  std::vector<std::size_t> drawn;
  double sum = 0.0, squares = 0.0;
  for (int s = 0; s < series; ++s) {
    drawn.clear();
    while (drawn.size() < count) {
      const std::size_t start = random() % count;
      for (std::size_t k = 0; k < length && drawn.size() < count; ++k)
        drawn.push_back(first + (start + k) % count);
    }
    const double value = of(drawn);
    sum += value, squares += value * value;
  }
  const double mean = sum / series;
  return std::sqrt(std::max(0.0, squares / series - mean * mean));
}

}  // namespace

BlockMeans::BlockMeans(std::size_t quantities, double time, std::size_t blocks)
    : quantities_{quantities},
      block_time_{time / static_cast<double>(blocks)},
      weight_(blocks),
      sums_(blocks * quantities) {}

void BlockMeans::add(double t, double weight, std::span<const double> values) {
  const double place = std::clamp(t / block_time_, 0.0, static_cast<double>(blocks() - 1));
  const auto block = static_cast<std::size_t>(place);
  weight_[block] += weight;
  for (std::size_t k = 0; k < quantities_; ++k)
    sums_[block * quantities_ + k] += weight * values[k];
}

double BlockMeans::block_mean(std::size_t block, std::size_t quantity) const {
  return weight_[block] > 0.0 ? sum(block, quantity) / weight_[block] : 0.0;
}

double BlockMeans::mean(std::size_t quantity, std::size_t first, std::size_t last) const {
  double weight = 0.0, total = 0.0;
  for (std::size_t block = first; block < last; ++block)
    weight += weight_[block], total += sum(block, quantity);
  return weight > 0.0 ? total / weight : 0.0;
}

Estimate BlockMeans::estimate(std::size_t quantity, std::size_t first) const {
  return {mean(quantity, first, blocks()), bootstrap_error(first, blocks(), [&](std::span<const std::size_t> drawn) {
            double weight = 0.0, total = 0.0;
            for (const std::size_t block : drawn)
              weight += weight_[block], total += sum(block, quantity);
            return weight > 0.0 ? total / weight : 0.0;
          })};
}

Estimate BlockMeans::ratio(std::size_t over, std::size_t under, std::size_t first) const {
  const auto quotient = [](double a, double b) { return b != 0.0 ? a / b : 0.0; };
  return {quotient(mean(over, first, blocks()), mean(under, first, blocks())),
          bootstrap_error(first, blocks(), [&](std::span<const std::size_t> drawn) {
            double a = 0.0, b = 0.0;
            for (const std::size_t block : drawn)
              a += sum(block, over), b += sum(block, under);
            return quotient(a, b);
          })};
}

void BlockMeans::remember(Memory& memory) {
  memory.numbers("weight", weight_);
  memory.numbers("sums", sums_);
}

}  // namespace talus
