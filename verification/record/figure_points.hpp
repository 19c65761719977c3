#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/record/csv.hpp"
#include "verification/record/figure.hpp"

namespace talus::records {

/// The data of a figure as CSV in long form: columns series, x, y and, if any series has bars, y_low, y_high (equal to
/// y for a series without), and, if any has values, value (0 for a series without). 17 significant digits: read back,
/// the doubles are the same. The figure's columns must be those of name_columns().
[[nodiscard]] std::string csv_of(const Figure& figure);

/// Which rows of a CSV file belong to a figure.
enum class Rows {
  all,   ///< each belongs to one of its series
  some,  ///< several figures may share the file
};

/// Fills the points of each series from the columns that it names. RecordError, naming file and line or column, if a
/// column is missing, a number is not finite, a series has no row, or a row belongs to no series where all must.
void read_points(Figure& figure, const Csv& csv, Rows rows);

/// The same from the figure's CSV file in `folder`; RecordError, too, if that cannot be read.
void read_points(Figure& figure, const std::filesystem::path& folder, Rows rows);

/// Fills the points of figures that share CSV files in `folder`, each of which is read once. RecordError as above.
void read_points(std::vector<Figure>& figures, const std::filesystem::path& folder);

}  // namespace talus::records
