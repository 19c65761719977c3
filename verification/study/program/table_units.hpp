#pragma once

#include "verification/record/csv.hpp"

namespace talus::verification::problems {

/// Worst difference of two tables of the same run, in US and in SI units, over the largest value of the column. Columns
/// without a unit have the same texts, or numbers. NaN for another column, another number of rows, an unknown unit or
/// another text.
[[nodiscard]] double units_error(const records::Csv& in_feet, const records::Csv& in_metres);

}  // namespace talus::verification::problems
