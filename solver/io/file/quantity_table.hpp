#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/base/units.hpp"

namespace talus {

/// Name and unit of the head of a column, "speed [ft/s]"; the unit is empty if there is none.
[[nodiscard]] std::pair<std::string, std::string> name_and_unit(std::string_view head);

/// A column of a table of quantities.
struct QuantityColumn {
  std::string name;
  Dimension dimension;
  std::vector<double> values{};  ///< in consistent units, one for each row
};

/// The unit in which a table has quantities of a dimension.
struct ColumnUnit {
  std::string symbol;
  double size{};  ///< in SI
};
/// Degrees for angles, else the consistent unit of the system.
[[nodiscard]] ColumnUnit column_unit(Dimension dimension, const UnitSystem& units);

/// A column that a table may have, with the values allowed in it.
struct AllowedColumn {
  std::string name;
  Dimension dimension;
  Range range{Range::any};
};

/// Reads a CSV file whose header names each column with its unit, e.g. `speed [ft/s]`; pure numbers need none. Returns
/// the columns in the file's order, in consistent units of `units`. Errors: IoError; InputError with file, line or
/// column, what was found and what is allowed: an unknown or repeated column, a unit that is missing or of another
/// dimension, a cell that is no number or outside the range, no row.
[[nodiscard]] std::vector<QuantityColumn> read_quantity_table(const std::filesystem::path& file,
                                                              const std::vector<AllowedColumn>& allowed,
                                                              const UnitSystem& units);

/// Text of the CSV file of columns in SI units, written with the unit of column_unit() in each head. All columns have
/// the same number of rows.
[[nodiscard]] std::string quantity_csv(const std::vector<QuantityColumn>& columns, const UnitSystem& units);

}  // namespace talus
