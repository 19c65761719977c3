#pragma once

#include <cstddef>

/// Operations on all numbers of a row, one pack at a time.
namespace talus {

/// out = x + h rate; out may be x.
void add_scaled(double* out, const double* x, double h, const double* rate, std::size_t count);

/// Whether all numbers of x and y are finite.
[[nodiscard]] bool all_finite(const double* x, const double* y, std::size_t count);

/// Number of rows for which the loop of take_extremes() is unrolled.
inline constexpr std::size_t block_rows = 8;
/// Updates the minima and maxima so far of `count` numbers, and their first times, with `rows` values of each, row by
/// row in x at these times; NaN changes neither.
void take_extremes(const double* x, const double* times, std::size_t rows, std::size_t count, double* minimum,
                   double* minimum_time, double* largest, double* maximum_time);

}  // namespace talus
