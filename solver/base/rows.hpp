#pragma once

#include <cstddef>

/// Operations on all numbers of a row, one pack at a time.
namespace talus {

/// out = x + h rate; out may be x.
void add_scaled(double* out, const double* x, double h, const double* rate, std::size_t count);

/// Whether all numbers of x and y are finite.
[[nodiscard]] bool all_finite(const double* x, const double* y, std::size_t count);

/// Updates the minima and maxima so far, and their times, with the values x at `time`; NaN changes neither.
void take_extremes(const double* x, double time, std::size_t count, double* least, double* least_time, double* largest,
                   double* largest_time);

}  // namespace talus
