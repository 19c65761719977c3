#pragma once

#include <cstddef>

/// What is done to every number of a row, a pack at a time.
namespace talus {

/// out = x + h rate; out may be x.
void add_scaled(double* out, const double* x, double h, const double* rate, std::size_t count);

/// Whether all of both are finite.
[[nodiscard]] bool all_finite(const double* x, const double* y, std::size_t count);

/// Takes the values x of one time into the least and the largest so far, with their times; what is not a number changes
/// neither.
void take_extremes(const double* x, double time, std::size_t count, double* least, double* least_time, double* largest,
                   double* largest_time);

}  // namespace talus
