#pragma once

#include <string>
#include <vector>

#include "verification/check/figure.hpp"

namespace talus::verification {

/// The word that stands for each series in the CSV column `series`: its label in lower case with '_' for all but
/// letters and digits, numbered where two would be the same.
[[nodiscard]] std::vector<std::string> series_keys(const Figure& figure);

/// The data of a figure as CSV in long form: columns series, x, y and, if any series has bars, y_low, y_high (equal to
/// y for a series without), and, if any has values, value (0 for a series without). 17 significant digits: read back,
/// the doubles are the same.
[[nodiscard]] std::string csv_of(const Figure& figure);

/// Fills the points of `figure.series`, in the order of `keys`, from the text of a CSV that `csv_of` wrote.
/// std::invalid_argument, naming the line, if a number is not finite, a row is short or a series has no row.
void read_points(const std::string& csv, const std::vector<std::string>& keys, Figure& figure);

}  // namespace talus::verification
