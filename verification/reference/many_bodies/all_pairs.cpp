#include "verification/reference/many_bodies/all_pairs.hpp"

#include <cmath>
#include <cstddef>

namespace talus::verification::reference {

void AllPairs::step(double h) {
  const std::vector<double> old_vx = vx, old_vy = vy;
  const std::size_t discs = x.size();
  const auto push = [&](std::size_t i, std::size_t j) {
    const double dx = x[j] - x[i], dy = y[j] - y[i];
    const double distance = std::sqrt(dx * dx + dy * dy), overlap = radius[i] + radius[j] - distance;
    if (!(overlap > 0.0)) return;
    const double nx = dx / distance, ny = dy / distance;
    const double closing = -((old_vx[j] - old_vx[i]) * nx + (old_vy[j] - old_vy[i]) * ny);
    const double force = stiffness * overlap + damping * closing;
    if (!(force > 0.0)) return;
    vx[i] -= h * inverse_mass[i] * (force * nx), vy[i] -= h * inverse_mass[i] * (force * ny);
    vx[j] += h * inverse_mass[j] * (force * nx), vy[j] += h * inverse_mass[j] * (force * ny);
  };
  for (std::size_t n = 0; n < discs; ++n) {
    const std::size_t i = backwards ? discs - 1 - n : n;
    for (std::size_t j = i + 1; j < discs; ++j)
      push(i, j);
  }
  for (std::size_t i = 0; i < discs; ++i)
    x[i] += h * vx[i], y[i] += h * vy[i];
}

}  // namespace talus::verification::reference
