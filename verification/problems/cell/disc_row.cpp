#include "verification/problems/cell/disc_row.hpp"

#include <algorithm>

namespace talus::verification::problems {

FilledRow fill(const DiscRow& row) {
  FilledRow filled;
  const std::size_t count = row.velocity.size();
  std::vector<double> x(count);
  for (std::size_t i = count; i-- > 1;)
    x[i - 1] = x[i] - 2.0 * row.radius - row.gap[i - 1];
  for (std::size_t i = 0; i < count; ++i) {
    filled.shapes.add(row.radius, 1.0 / row.mass);
    filled.discs.add(x[i], 0.0, row.velocity[i], 0.0);
  }
  return filled;
}

bool ordered(const Discs& discs) { return std::is_sorted(discs.vx.begin(), discs.vx.end()); }

}  // namespace talus::verification::problems
