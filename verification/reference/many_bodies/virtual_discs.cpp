#include "verification/reference/many_bodies/virtual_discs.hpp"

#include <algorithm>
#include <cmath>

namespace talus::verification::reference {

void VirtualDiscs::step(double h) {
  const std::size_t count = x.size();
  largest.resize(count * count);
  contacts.clear();
  std::vector<double> fx(count), fy(count);
  // A real disc and another disc, either real or its virtual image.
  const auto touch = [&](std::size_t real, std::size_t other, double shift) {
    if (real >= free && other >= free) return 0.0;
    const double dx = x[other] + shift - x[real], dy = y[other] - y[real];
    const double distance = std::sqrt(dx * dx + dy * dy), overlap = diameter - distance;
    if (overlap <= 0.0) return overlap;
    double& deepest = largest[std::min(real, other) * count + std::max(real, other)];
    if (overlap > deepest) {
      lost += 0.5 * k1 * (1.0 - k1 / k2) * (overlap - deepest) * (overlap + deepest);
      deepest = overlap;
    }
    const double force = std::max(0.0, std::min(k1 * overlap, k1 * deepest - k2 * (deepest - overlap)));
    if (force > 0.0) contacts.push_back({real, other, force, overlap, dx, dy});
    fx[other] += force * dx / distance, fy[other] += force * dy / distance;
    fx[real] -= force * dx / distance, fy[real] -= force * dy / distance;
    return overlap;
  };
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const double here = touch(i, j, 0.0), other_left = touch(i, j, -width), own_left = touch(j, i, -width);
      if (std::max({here, other_left, own_left}) <= 0.0) largest[i * count + j] = 0.0;
    }
  }
  const std::size_t block = free + wall;
  force_on_block_x = force_on_block_y = force_on_base_x = force_on_base_y = 0.0;
  for (std::size_t i = free; i < block; ++i)
    force_on_base_x += fx[i], force_on_base_y += fy[i];
  for (std::size_t i = block; i < count; ++i)
    force_on_block_x += fx[i], force_on_block_y += fy[i];
  for (std::size_t i = 0; i < free; ++i)
    vx[i] += h * fx[i] / mass, vy[i] += h * fy[i] / mass;
  for (std::size_t i = block; i < count; ++i)
    vy[i] += h * (force_on_block_y / block_mass - gravity);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] += h * vx[i], y[i] += h * vy[i];
    if (x[i] >= left + width) x[i] -= width;
    if (x[i] < left) x[i] += width;
  }
}

}  // namespace talus::verification::reference
