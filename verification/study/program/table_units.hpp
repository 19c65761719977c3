#pragma once

#include <string>

#include "verification/record/csv.hpp"

namespace talus::verification::problems {

/// Name and unit of a column: "x.end [ft]"; without a unit it is empty.
struct TableHead {
  explicit TableHead(const std::string& head);

  std::string name, unit;
};

/// Size in SI of a unit that tables have, such as "lbf ft"; NaN for an unknown one.
[[nodiscard]] double size_of_unit(const std::string& unit);

/// Worst difference of two tables of the same run, in US and in SI units, over the largest value of the column. Columns
/// without a unit have the same texts, or numbers. NaN for another column, another number of rows, an unknown unit or
/// another text.
[[nodiscard]] double units_error(const records::Csv& in_feet, const records::Csv& in_metres);

}  // namespace talus::verification::problems
