#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/record/csv.hpp"
#include "verification/record/figure.hpp"

namespace talus::records {

/// The data of a figure as CSV in long form: columns series, x, y and, if any series has error bars, y_low, y_high
/// (equal to y for a series without), and, if any has values, value (0 for a series without). With 17 significant
/// digits, the same doubles are read back. The figure's columns must be those of name_columns().
[[nodiscard]] std::string csv_of(const Figure& figure);

/// Rule for the rows of a CSV file that a figure reads.
enum class Rows {
  all,   ///< each row must belong to one of its series
  some,  ///< other rows are allowed: several figures may share the file
};

/// Reads the points of each series from its columns. RecordError, with file and line or column, if a column is missing,
/// a number is not finite, a series has no row, or (Rows::all) a row belongs to no series.
void read_points(Figure& figure, const Csv& csv, Rows rows);

/// Reads the points from the figure's CSV file in `folder`; RecordError also if that file cannot be read.
void read_points(Figure& figure, const std::filesystem::path& folder, Rows rows);

/// Reads the points of figures that share CSV files in `folder`; each file is read once. RecordError as above.
void read_points(std::vector<Figure>& figures, const std::filesystem::path& folder);

}  // namespace talus::records
