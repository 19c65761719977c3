#include "solver/base/rows.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "solver/base/pack.hpp"

namespace talus {

TALUS_CLONES void add_scaled(double* out, const double* x, double h, const double* rate, std::size_t count) {
  std::size_t i = 0;
  for (; i + pack_size <= count; i += pack_size) {
    Pack sum, more;
    load(sum, x + i), load(more, rate + i);
    store(sum + h * more, out + i);
  }
  for (; i < count; ++i)
    out[i] = x[i] + h * rate[i];
}

TALUS_CLONES bool all_finite(const double* x, const double* y, std::size_t count) {
  // For finite x, x - x is zero, or -0 if sums are rounded downward: no bit but the sign is set. For other x it is NaN.
  Sizes found{};
  std::size_t i = 0;
  for (; i + pack_size <= count; i += pack_size) {
    Pack a, b;
    load(a, x + i), load(b, y + i);
    a -= a, b -= b;
    Sizes bits, more;
    std::memcpy(&bits, &a, sizeof bits), std::memcpy(&more, &b, sizeof more);
    found |= bits | more;
  }
  std::uint64_t rest = 0;
  for (; i < count; ++i)
    rest |= std::bit_cast<std::uint64_t>(x[i] - x[i]) | std::bit_cast<std::uint64_t>(y[i] - y[i]);
  constexpr std::int64_t sign = std::numeric_limits<std::int64_t>::min();
  return (static_cast<std::int64_t>(rest) & ~sign) == 0 && !any_bit(found & ~sign);
}

TALUS_CLONES void take_extremes(const double* x, const double* times, std::size_t rows, std::size_t count,
                                double* minimum, double* minimum_time, double* largest, double* maximum_time) {
  // A value visited twice, in a last pack that overlaps the one before it, changes no extreme the second time.
  const auto take = [&](std::size_t i, auto left, auto number_of_rows) __attribute__((always_inline)) {
    Pack low, low_time, high, high_time;
    load(low, minimum + i, left), load(low_time, minimum_time + i, left);
    load(high, largest + i, left), load(high_time, maximum_time + i, left);
    const double* next = x + i;
    for (std::size_t row = 0; row < number_of_rows; ++row, next += count) {
      const Pack now{times[row], times[row], times[row], times[row]};
      Pack value;
      load(value, next, left);
      low_time = value < low ? now : low_time, low = value < low ? value : low;
      high_time = value > high ? now : high_time, high = value > high ? value : high;
    }
    store(low, minimum + i, left), store(low_time, minimum_time + i, left);
    store(high, largest + i, left), store(high_time, maximum_time + i, left);
  };
  if (rows == block_rows) {
    using Block = std::integral_constant<std::size_t, block_rows>;
    for_packs(
        count, [&](std::size_t i, auto left) __attribute__((always_inline)) { take(i, left, Block{}); });
  } else {
    for_packs(
        count, [&](std::size_t i, auto left) __attribute__((always_inline)) { take(i, left, rows); });
  }
}

}  // namespace talus
