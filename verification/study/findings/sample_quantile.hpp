#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace talus::verification::problems {

/// The value at the fraction `probability` of the way from the first to the last of the values, in increasing order,
/// linear between neighbours (Hyndman and Fan 1996, definition 7). Precondition: there is a value.
[[nodiscard]] inline double sample_quantile(const std::vector<double>& sorted, double probability) {
  const double rank = probability * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  return std::lerp(sorted[below], sorted[std::min(below + 1, sorted.size() - 1)], rank - static_cast<double>(below));
}

}  // namespace talus::verification::problems
