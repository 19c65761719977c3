#include "solver/integrate/linear_limit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace talus {

double leapfrog_limit(double damping_ratio) {
  const double xi = damping_ratio;
  return 2.0 * (std::sqrt(1.0 + xi * xi) - xi);
}

/// Brackets the limit on a grid, then bisects.
double first_growth(double (*growth)(double h, double damping_ratio), double damping_ratio) {
  double stable = 0.0;
  double h = 0.001;
  while (growth(h, damping_ratio) <= 1.0 + 1e-12)
    stable = h, h += 0.001;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (stable + h);
    (growth(middle, damping_ratio) <= 1.0 + 1e-12 ? stable : h) = middle;
  }
  return stable;
}

double fourth_order_growth(double h, double damping_ratio) {
  const double xi = damping_ratio;
  const std::complex<double> root = std::sqrt(std::complex<double>{xi * xi - 1.0, 0.0});
  double largest = 0.0;
  for (const std::complex<double> z : {h * (-xi + root), h * (-xi - root)}) {
    largest = std::max(largest, std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))));
  }
  return largest;
}

}  // namespace talus
