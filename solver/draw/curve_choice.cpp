#include "solver/draw/curve_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace talus::app {

double range_of(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    low = std::min(low, value), high = std::max(high, value);
  }
  return low <= high ? high - low : 0.0;
}

std::vector<std::size_t> indices_of_largest(const std::vector<double>& values, std::size_t maximum) {
  std::vector<std::size_t> indices(values.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  indices.resize(std::min(maximum, indices.size()));
  std::sort(indices.begin(), indices.end());
  return indices;
}

void note_left_out(const std::string& panel, std::size_t drawn, std::size_t all, std::vector<std::string>& notes) {
  if (drawn == all) return;
  notes.push_back(
      fmt::format("{}: {} of {} curves drawn, those with the largest range; --all draws all, --element those named",
                  panel, drawn, all));
}

}  // namespace talus::app
