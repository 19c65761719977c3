#include "solver/granular/discs.hpp"

namespace talus {
namespace {

/// Adds h times `rates` to `values`, element by element.
template <class Numbers>
void add(Numbers& values, const Numbers& rates, double h) {
  double* const value = values.data();
  const double* const rate = rates.data();
  for (std::size_t i = 0, count = values.size(); i < count; ++i)
    value[i] += h * rate[i];
}

}  // namespace

void kick_velocities(Discs& discs, const DiscRates& rates, double h) {
  add(discs.vx, rates.vx, h), add(discs.vy, rates.vy, h);
  add(discs.spin, rates.spin, h);
  add(discs.work, rates.work, h);
}

}  // namespace talus
