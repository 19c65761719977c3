#include "solver/integrate/linear_limit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace talus {

double leapfrog_limit(double damping_ratio) {
  const double xi = damping_ratio;
  return 2.0 * (std::sqrt(1.0 + xi * xi) - xi);
}

/// Brackets the limit on a grid, then bisects. The last result of the thread is cached: the run monitor evaluates the
/// limit at each sample, and most scenes have one damping ratio, 0.
double first_growth(double (*growth)(double h, double damping_ratio), double damping_ratio) {
  struct Found {
    double (*growth)(double, double) = nullptr;
    double damping_ratio = 0.0, limit = 0.0;
  };
  thread_local Found last;
  if (last.growth == growth && last.damping_ratio == damping_ratio) return last.limit;
  double stable = 0.0;
  double h = 0.001;
  while (growth(h, damping_ratio) <= 1.0 + 1e-12)
    stable = h, h += 0.001;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (stable + h);
    (growth(middle, damping_ratio) <= 1.0 + 1e-12 ? stable : h) = middle;
  }
  last = {growth, damping_ratio, stable};
  return stable;
}

double fourth_order_growth(double h, double damping_ratio) {
  const double xi = damping_ratio;
  const std::complex<double> root = std::sqrt(std::complex<double>{xi * xi - 1.0, 0.0});
  const auto factor = [](const std::complex<double>& z) {
    return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))));
  };
  const double slow = factor(h * (-xi + root));
  // Conjugate roots have one factor.
  return xi < 1.0 ? slow : std::max(slow, factor(h * (-xi - root)));
}

}  // namespace talus
