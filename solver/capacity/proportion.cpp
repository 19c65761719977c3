#include "solver/capacity/proportion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/error.hpp"

namespace talus {

Interval wilson_interval(std::size_t hits, std::size_t trials) {
  TALUS_DEMAND(hits <= trials);
  if (trials == 0) return {0.0, 1.0};
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(hits) / n, z2 = normal_975 * normal_975;
  const double centre = (p + 0.5 * z2 / n) / (1.0 + z2 / n);
  const double half = normal_975 / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + 0.25 * z2 / (n * n));
  // Both ends are exact where no trial, or each, was a hit.
  return {hits == 0 ? 0.0 : centre - half, hits == trials ? 1.0 : centre + half};
}

SampleQuantile sample_quantile(std::vector<double> sample, double probability) {
  TALUS_DEMAND(!sample.empty() && probability > 0.0 && probability < 1.0);
  std::ranges::sort(sample);
  const auto n = static_cast<double>(sample.size());
  const double rank = probability * (n - 1.0);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sample.size() - 1);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  SampleQuantile found{std::lerp(sample[below], sample[above], rank - static_cast<double>(below)),
                       {-infinity, infinity}};
  // The quantile is below the k-th value if fewer than k values lie below it.
  constexpr double tail = 0.025;
  double up_to_k = 0.0;
  for (std::size_t k = 0; k <= sample.size(); ++k) {
    const auto i = static_cast<double>(k);
    const double chance = std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                                   i * std::log(probability) + (n - i) * std::log1p(-probability));
    if (up_to_k + chance <= tail && k < sample.size()) found.interval.low = sample[k];
    up_to_k += chance;
    if (up_to_k >= 1.0 - tail) {
      if (k < sample.size()) found.interval.high = sample[k];
      break;
    }
  }
  return found;
}

}  // namespace talus
